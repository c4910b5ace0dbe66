3.1
unknown names
DEF_VAR A
DEF_POS P
A = B * C
A = ATAN2 D E
A = SQRT G
P = ROT_X S T
H = A
I += P.X
A = K
END
