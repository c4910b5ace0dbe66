3.1
Repeat loop
DEF_VAR N
N = 0
REPEAT
N = N + 1
UNTIL N >= 2
END
