3.1
A title
SLEEP = 100
END
