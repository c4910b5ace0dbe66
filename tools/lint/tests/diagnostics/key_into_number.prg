3.1
A title
KEY_IN 5
END
