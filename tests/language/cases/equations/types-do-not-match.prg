3.1
types do not match
DEF_VAR A
DEF_POS P
DEF_JOINT Q
A = 1
P.X = 1
Q.J1 = 1
A = P
A = Q
P = A
P = 5
P = Q
Q = P
P.X = P
A = P + P
P = P + A
P = A * P
P = P * 2
A = P + Q
P = Q + Q
P += A
P *= 2
A += P
Q -= P
SLEEP A
END
