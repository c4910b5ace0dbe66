3.1
Else with label on its line
DEF_VAR A
IF 1 == 2 THEN
A = 1
L1: ELSE
A = 2
ENDIF
END
