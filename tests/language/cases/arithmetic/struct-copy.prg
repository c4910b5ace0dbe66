3.1
Struct copy
DEF_POS P, R1
DEF_JOINT Q, S
P.X = 1
P.Y = 2
P.Z = 3
R1 = P
Q.J1 = 4
Q.J2 = 5
Q.J3 = 6
S = Q
END
