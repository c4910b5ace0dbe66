3.2
One long line
F_MESSAGE one
F_MESSAGE two
END
