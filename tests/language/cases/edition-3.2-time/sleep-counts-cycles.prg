3.2
SLEEP at three steps a turn
DEF_VAR A
TIP_SPEED_UP 3
SLEEP 60
A = 1
END
