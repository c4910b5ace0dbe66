3.1
Rotation update
DEF_POS P
P.X = 1
P.Y = 2
P.Z = 3
P += ROT_Z P 0
P -= UNIT_VECT P
END
