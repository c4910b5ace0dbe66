3.1
Elseif reached behind goto
DEF_VAR A
IF 1 == 1 THEN
GOTO L1:
A = 1
L1:
ELSEIF 1 == 1 THEN
A = 2
ENDIF
END
