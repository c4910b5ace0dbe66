3.1
A title
LOCK F1
END
