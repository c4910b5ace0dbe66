3.1
Sqrt of zero stays
DEF_VAR A
A = -0.0
A = SQRT A
A = 9
A = SQRT A
END
