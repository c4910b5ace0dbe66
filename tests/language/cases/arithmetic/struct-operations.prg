3.1
Struct operations
DEF_POS P, Q
P.X = 6
P.Y = 8
P.Z = 1
Q.X = 2
Q.Y = 4
Q.Z = 1
P = P + Q
P = P - Q
P = P * Q
P = Q / P
END
