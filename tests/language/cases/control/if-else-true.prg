3.1
If else true
DEF_VAR A
IF 1 < 2 THEN
A = 1
ELSE
A = 2
ENDIF
END
