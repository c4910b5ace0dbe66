3.2
A speed that no turn has
DEF_VAR N
N = 256
TIP_SPEED_UP N
END
