3.1
Norm overflows
DEF_VAR A
DEF_POS P
P.X = 1.5
P.Y = 1.5
P.Z = 1.5
P.X /= 1E-300
A = NORM P
END
