3.1
Acos below minus one
DEF_VAR A
A = ACOS -2
END
