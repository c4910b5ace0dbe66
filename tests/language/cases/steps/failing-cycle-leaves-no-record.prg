3.1
Failing cycle leaves no record
DEF_VAR A, B
A = 1
B = A / 0
END
