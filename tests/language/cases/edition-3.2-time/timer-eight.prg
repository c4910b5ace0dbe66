3.2
A timer that does not exist
DEF_VAR N
N = 7.9
START_TIMER N
N = 8
STOP_TIMER N
END
