3.1
structs have no sign
DEF_VAR V
DEF_POS P
DEF_JOINT Q
V = 1
P.X = V
Q.J1 = P.X
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
P = -O
P = O + -P
P = UNIT_VECT -O
V = NORM -P
P.X = -O.X + 1
END
