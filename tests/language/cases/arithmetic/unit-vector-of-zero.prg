3.1
Unit vector of zero
DEF_POS P
P.X = 0
P.Y = 0
P.Z = 0
P = UNIT_VECT P
END
