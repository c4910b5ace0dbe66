3.1
A title
DEF_POS P
P[0] = 3
END
