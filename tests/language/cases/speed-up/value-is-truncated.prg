3.2
Value is truncated
DEF_VAR A N
N = 2.99
TIP_SPEED_UP N
A = 1
A = 2
A = 3
END
