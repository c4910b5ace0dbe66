3.2
Three steps in a turn
DEF_VAR A
TIP_SPEED_UP 3
A = 1
A = 2
A = 3
A = 4
END
