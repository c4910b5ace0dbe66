3.1
A title
企
END
