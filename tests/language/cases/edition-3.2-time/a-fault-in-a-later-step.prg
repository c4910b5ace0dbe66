3.2
Earlier steps of the cycle stand
DEF_VAR A Z
Z = 0
TIP_SPEED_UP 3
A = 1
LAMP_ON 2
A = A / Z
END
