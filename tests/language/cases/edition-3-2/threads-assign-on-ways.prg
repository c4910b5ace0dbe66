3.2
What no way assigns does not count
DEF_VAR A C
START_THREAD T:
SLEEP C
EXIT
A = 1
EXIT
THREAD T:
  C = A
THREADEND
END
