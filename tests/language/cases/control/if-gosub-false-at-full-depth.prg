3.1
If gosub false at full depth
DEF_VAR N
N = 0
L1:
N += 1
IF N <= 10 GOSUB L1:
IF N == 0 GOSUB L1:
CALL S1:
EXIT
SUBROUTINE S1:
SUBEND
END
