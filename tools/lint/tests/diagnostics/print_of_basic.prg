3.1
A title
PRINT "hello"
END
