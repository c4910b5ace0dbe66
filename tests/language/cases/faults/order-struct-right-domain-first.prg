3.1
Order struct right domain first
DEF_POS P, Z
Z.X = 0
Z.Y = 0
Z.Z = 0
P += UNIT_VECT Z
P = Z
END
