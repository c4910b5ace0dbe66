3.1
one operation
DEF_VAR A
A = 20
A = A + A + A
A = A A
A = A +
A =
A = SIN A + 1
A = A + SIN A
A = (A + A)
A = SIN(A)
A == A
SLEEP A
END
