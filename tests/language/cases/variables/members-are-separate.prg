3.1
Members are separate
DEF_VAR A
DEF_POS P
P.X = 1
A = P.X
A = P.Y
END
