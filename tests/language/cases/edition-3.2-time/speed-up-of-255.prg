3.2
The highest speed
DEF_VAR N
N = 255.9
TIP_SPEED_UP N
END
