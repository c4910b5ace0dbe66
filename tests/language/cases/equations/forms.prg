3.1
forms
DEF_VAR A B
DEF_POS P S
DEF_JOINT Q T
A = 1
B = -A
A = B + 1
A = B - -1
A = P.X * Q.J1
A = A / 2
A += 1
A -= B
A *= P.X
A /= 2
A += SIN B
P.X = A
Q.J1 = A
P = S
S = P + P
S = P - S
S = P * S
P = P / S
P += S
P -= S
P *= S
P /= S
Q = T
T = Q - T
Q += T
A = INT B
A = ABS -B
A = SQRT 2
A = SIN P.X
A = COS A
A = TAN A
A = ASIN A
A = ACOS A
A = ATAN A
A = DEG2RAD A
A = RAD2DEG A
A = ATAN2 A -B
A = NORM P
A = NORM Q
P = UNIT_VECT S
P = ROT_X S 90
P = ROT_Y S A
P = ROT_Z P -A
END
