3.1
Else behind inner if
DEF_VAR A
IF 1 == 1 THEN
IF 1 == 2 THEN
A = 1
ENDIF
ELSE
A = 2
ENDIF
END
