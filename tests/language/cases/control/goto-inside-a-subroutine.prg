3.1
Goto inside a subroutine
DEF_VAR N
N = 0
CALL S1:
EXIT
SUBROUTINE S1:
N += 1
IF N < 2 GOTO S1:
SUBEND
END
