3.2
Fault of the main program
DEF_VAR A B
B = 0
START_THREAD T:
A = 1 / B
EXIT
THREAD T:
A = 20
THREADEND
END
