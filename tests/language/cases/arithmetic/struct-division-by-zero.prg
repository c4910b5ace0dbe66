3.1
Struct division by zero
DEF_POS P, Q
P.X = 1
P.Y = 1
P.Z = 1
Q = P
Q.Y = 0
P /= Q
END
