3.1
If false
DEF_VAR A
IF 1 == 2 THEN
A = 1
ENDIF
A = 2
END
