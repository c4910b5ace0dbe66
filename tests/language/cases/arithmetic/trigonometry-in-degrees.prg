3.1
Trigonometry in degrees
DEF_VAR A, E
E = 1
A = SIN 30
E += A
A = SIN -90
E += A
A = COS 60
E += A
A = COS 180
E += A
A = TAN 45
E += A
A = TAN -45
E += A
IF E > 1E-9 GOTO BAD:
IF E < -1E-9 GOTO BAD:
EXIT
BAD: END
