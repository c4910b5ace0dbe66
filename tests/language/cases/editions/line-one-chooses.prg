3.2
Line one chooses
DEF_VAR A
A = 1
TIP_SPEED_UP 2
A = 2
A = 3
A = 4
END
