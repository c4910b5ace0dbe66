3.1
Key in waits
KEY_IN
END
