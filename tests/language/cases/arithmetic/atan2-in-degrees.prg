3.1
Atan2 in degrees
DEF_VAR A
A = ATAN2 0 -1
A = ATAN2 0 1
A = ATAN2 -0.0 -1
A = ATAN2 0, 5
END
