3.2
Read before the other assigns fails
DEF_VAR A B
START_THREAD T:
REM
REM
B = 1
EXIT
THREAD T:
A = B
SLEEP A
THREADEND
END
