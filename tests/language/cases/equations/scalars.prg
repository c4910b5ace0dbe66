3.1
scalars
DEF_VAR V
DEF_POS P
DEF_JOINT Q
V = 1
P.X = V; P.Y = V; P.Z = V
Q.J1 = P.X; Q.J2 = P.X; Q.J3 = P.X
V = Q.J1
DEF_VAR W
DEF_POS O
DEF_JOINT T
W = 2
O = P
T = Q
V = W
W = NORM O
W = NORM T
V = -W
P.X = Q.J2
Q.J3 += -P.Y
V = W + P.X
V -= 1 * -W
V *= P.X / Q.J1
V /= 5 - CHAR_A
V = INT P.X
V = ABS P.X
V = SQRT P.X
V = SIN P.X
V = COS P.X
V = TAN P.X
V = ASIN P.X
V = ACOS P.X
V = ATAN P.X
V = DEG2RAD P.X
V = RAD2DEG P.X
Q.J1 += SIN -W
V = ATAN2 W -P.X
V = ATAN2 1 2
V = NORM P
V += NORM Q
END
