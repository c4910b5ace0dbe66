3.2
Sleep counts cycles
DEF_VAR A
A = 0
TIP_SPEED_UP 2
A += 1
SLEEP 60
A += 1
A += 1
SLEEP 1
A += 1
END
