3.1
A title
SLEEP 4,5
END
