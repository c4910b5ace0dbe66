3.1
Two errors
DEF_VAR A
A = B + 1
FLY F1 10
END
