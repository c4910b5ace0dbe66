3.1
Norm overflows
DEF_VAR A
DEF_POS P
P.X = 15
P.Y = 15
P.Z = 1.5
P.X /= 1E-307
P.Y /= 1E-307
A = NORM P
END
