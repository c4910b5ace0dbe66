3.1
A title
SLEEP １００
END
