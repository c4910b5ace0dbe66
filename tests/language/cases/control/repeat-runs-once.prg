3.1
Repeat runs once
DEF_VAR N
REPEAT
N = 1
UNTIL 1 == 1
END
