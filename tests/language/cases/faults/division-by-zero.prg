3.1
Division by zero
DEF_VAR A
A = 1
A /= 0
END
