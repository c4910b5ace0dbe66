3.1
Taken elseif reads nothing
DEF_VAR U
IF 1 == 1 THEN
ELSEIF U == 1 THEN
ELSE
U = 1
ENDIF
END
