3.1
Elseif none holds
DEF_VAR A
IF 1 == 2 THEN
A = 1
ELSEIF 1 == 3 THEN
A = 2
ELSEIF 1 == 4 THEN
A = 3
ELSE
A = 4
ENDIF
END
