3.1
A title
while True:
    SLEEP 10
END
