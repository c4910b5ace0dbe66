3.2
Initial posture leaves it
DEF_VAR A
TIP_SPEED_UP 2
INITIAL_POSTURE
A = 1
A = 2
A = 3
END
