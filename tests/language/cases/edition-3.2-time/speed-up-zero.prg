3.2
A speed that no turn has
DEF_VAR N
N = 0.9
TIP_SPEED_UP N
END
