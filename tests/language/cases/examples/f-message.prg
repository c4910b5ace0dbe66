3.2
A table of places for other programs to read
F_MESSAGE foot\tx y z\n
F_MESSAGE F1\t%@POS_F1.0%\n
END
