3.2
One line end is enough
F_MESSAGE one
F_MESSAGE two
F_MESSAGE \n
END
