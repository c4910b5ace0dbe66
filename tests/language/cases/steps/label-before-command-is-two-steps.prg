3.1
Label before command is two steps
DEF_VAR A
L1: A = 1
L2: L3: A = 2
END
