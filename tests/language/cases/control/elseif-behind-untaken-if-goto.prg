3.1
Elseif behind untaken if goto
DEF_VAR A
IF 1 == 1 THEN
IF 1 == 2 GOTO L1:
ELSEIF 1 == 1 THEN
A = 2
ENDIF
L1: END
