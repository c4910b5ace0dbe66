3.1
minus is the operator
DEF_VAR A,B
A = 5 -3
B = A - -A
B = A*-B
B = A--B
B = ATAN2 A -B
A -= -1
SLEEP B
END
