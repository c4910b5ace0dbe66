3.1
Rotation by zero
DEF_POS P
P.X = 1
P.Y = 2
P.Z = 3
P = ROT_X P 0
P = ROT_Y P 0
P = ROT_Z P 0
END
