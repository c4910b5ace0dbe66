3.1
Atan2 of zeros
DEF_VAR A
A = ATAN2 0 -0.0
END
