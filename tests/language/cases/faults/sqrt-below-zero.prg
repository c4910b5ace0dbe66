3.1
Sqrt below zero
DEF_VAR A
A = SQRT -1E-300
END
