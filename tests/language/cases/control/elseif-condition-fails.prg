3.1
Elseif condition fails
DEF_VAR U
IF 1 == 2 THEN
ELSEIF U == 1 THEN
U = 1
ENDIF
END
