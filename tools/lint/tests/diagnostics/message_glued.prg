3.1
A title
MESSAGE"hi"
END
