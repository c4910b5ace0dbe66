3.1
Unit vector
DEF_POS P
P.X = 0
P.Y = -4
P.Z = 0
P = UNIT_VECT P
END
