3.1
Set shows changes only
DEF_VAR A
A = 0
A = 0
A = -0.0
A = -0.0
END
