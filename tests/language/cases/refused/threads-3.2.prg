3.2
Threads, constants and texts of 3.2: refused forms
DEF_VAR V
V = 1
DEFINE A NOPE
DEFINE B 1 2
START_THREAD S:
STOP_THREAD S:
WAIT_THREAD S:
START_THREAD NOPE:
STOP_THREAD NOPE:
WAIT_THREAD NOPE:
START_THREAD T:
F_MESSAGE %V%xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
F_MESSAGE yyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyy
EXIT
SUBROUTINE S:
SUBEND
THREAD T:
  WHILE KB_HIT
    THREAD U:
    THREADEND
  WEND
THREADEND
THREAD T:
THREADEND
THREAD W
THREADEND T
THREAD NNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNN:
THREADEND
THREADEND
END
