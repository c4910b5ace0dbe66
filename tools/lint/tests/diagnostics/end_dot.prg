3.1
A title
MESSAGE x
END.
