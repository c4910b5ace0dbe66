3.1
Members are scalars
DEF_POS P
DEF_JOINT Q
P.X = 2
P.Z = -P.X
Q.J3 = P.X * P.Z
P.X += Q.J3
END
