3.2
Longer than the program
DEF_VAR A
TIP_SPEED_UP 255
A = 1
A = 2
END
