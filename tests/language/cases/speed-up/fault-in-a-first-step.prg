3.2
Fault in a first step
DEF_VAR A B
B = 0
TIP_SPEED_UP 3
A = 1
A = 2
REM
A = 1 / B
A = 3
END
