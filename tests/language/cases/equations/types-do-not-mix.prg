3.1
types do not mix
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
V = P
V = Q
P = V
P = 5
P = Q
Q = P
Q = 1
P = P.X
P.X = P
P += 1
P *= V
V = W + P
V = P + W
V = P + O
P = O + V
P = O * 5
P = V + O
P = O + Q
P = Q + T
Q = P + O
Q = T + O
V += P - O
P = V + W
P -= O + P.X
END
