3.1
structs
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
P = O
Q = T
P += O
Q /= T
P = O + P
Q = T - Q
P = P * P
Q *= T / T
P = UNIT_VECT O
P -= UNIT_VECT P
P = ROT_X O 90
P = ROT_Y P -W
P += ROT_Z O V
PTP F1 P
PTP_ANGLE F1 Q
END
