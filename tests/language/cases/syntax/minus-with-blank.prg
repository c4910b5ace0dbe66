3.1
minus with blank
DEF_VAR A
A = 20
A = - A
A = A - - A
A = ATAN2 A - A
A = ATAN2 A-A
SLEEP A
END
