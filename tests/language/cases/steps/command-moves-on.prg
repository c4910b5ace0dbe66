3.1
Command moves on
DEF_VAR A
A = 1
A = 2
END
