3.2
A timer is 0 in the cycle that starts it
DEF_VAR A B
TIP_SPEED_UP 2
START_TIMER 7
A = @TIMER7
B = @TIMER7
END
