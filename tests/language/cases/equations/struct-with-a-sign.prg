3.1
struct with a sign
DEF_POS P S
P.X = 1
S = -P
S = P + -P
S = UNIT_VECT -P
P.X = -S.X
END
