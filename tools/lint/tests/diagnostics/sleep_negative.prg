3.1
A title
SLEEP -1
END
