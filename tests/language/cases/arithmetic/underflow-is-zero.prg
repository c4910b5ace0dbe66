3.1
Underflow is zero
DEF_VAR A
A = 1
A = 1E-300 * 1E-300
END
