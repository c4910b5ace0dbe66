3.1
Else behind a false inner elseif
DEF_VAR A
IF 1 == 1 THEN
IF 1 == 2 THEN
ELSEIF 1 == 3 THEN
ENDIF
ELSE
A = 1
ENDIF
END
