3.2
Fault in a later step
DEF_VAR A B
B = 0
TIP_SPEED_UP 3
A = 1
A = 2
A = 1 / B
A = 3
END
