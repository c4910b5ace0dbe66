3.1
Declaration order in set
DEF_POS B
DEF_VAR Z
DEF_POS A
B.Z = 1
B.X = 2
B.Y = 3
A = B
Z = A.Y
END
