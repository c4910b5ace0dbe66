3.2
Key in waits
DEF_VAR A
TIP_SPEED_UP 5
A = 1
KEY_IN A
A += 1
END
