3.1
A title
DEF_POS P
P = 5
END
