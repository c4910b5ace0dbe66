3.2
Constant conditions near misses
DEF_VAR A B C
A = 0
IF A == 1 THEN
A = B
ENDIF
FOR A = 1 TO 5
A = C
NEXT
B = A
C = B
SLEEP C
END
