3.1
A title
MESSAGE one; two
END
