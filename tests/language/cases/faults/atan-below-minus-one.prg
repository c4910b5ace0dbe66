3.1
Atan below minus one
DEF_VAR A
A = ATAN -1.0000001
END
