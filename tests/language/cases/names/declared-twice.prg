3.1
declared twice
DEF_VAR A B
DEF_VAR A
DEF_POS B, C, C
A = 1
B = A
SLEEP B
C.X = B
SLEEP A
A = C.X
END
