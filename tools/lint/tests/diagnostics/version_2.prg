2.0
A title
END
