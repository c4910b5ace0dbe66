3.1
Minus after an operand
DEF_VAR A, B
A = 5 -3
A = 5 - -3
A = 5-3
A = 5*-3
B = -A
A = B - -A
A = -B-A
END
