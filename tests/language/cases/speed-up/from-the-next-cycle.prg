3.2
From the next cycle
DEF_VAR A
A = 1
TIP_SPEED_UP 3
A = 2
A = 3
A = 4
A = 5
TIP_SPEED_UP 1
A = 6
A = 7
A = 8
END
