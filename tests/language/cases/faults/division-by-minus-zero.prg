3.1
Division by minus zero
DEF_VAR A
A = 1 / -0.0
END
