3.1
left sides
DEF_VAR A
A = 1
5 = A
-A = 1
CHAR_A = A
SIN = A
PTP = A
SLEEP A
END
