3.1
Sleep negative
SLEEP -1
END
