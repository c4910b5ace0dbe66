3.2
Set is of the step
DEF_VAR A B
DEF_POS P
TIP_SPEED_UP 8
A = 1
B = 1
A = 2
A = 2
P.X = 1
A = 1
END
