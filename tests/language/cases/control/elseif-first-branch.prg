3.1
Elseif first branch
DEF_VAR A
IF 1 == 1 THEN
A = 1
ELSEIF 1 == 1 THEN
A = 2
ELSEIF 1 == 1 THEN
A = 3
ELSE
A = 4
ENDIF
END
