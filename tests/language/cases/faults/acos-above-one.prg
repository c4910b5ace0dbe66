3.1
Acos above one
DEF_VAR A
A = ACOS 1.0000001
END
