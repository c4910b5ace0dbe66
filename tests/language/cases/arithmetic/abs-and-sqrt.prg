3.1
Abs and sqrt
DEF_VAR A
A = ABS -2.5
A = ABS 3
A = ABS -0.0
A = SQRT 2.25
A = SQRT 0
A = SQRT 1E-6
END
