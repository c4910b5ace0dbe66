3.2
What another thread assigns counts
DEF_VAR A B C
START_THREAD T:
SLEEP A
B = 1
SLEEP C
EXIT
THREAD T:
  A = B
  SLEEP B
  C = 2
THREADEND
END
