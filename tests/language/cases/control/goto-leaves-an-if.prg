3.1
Goto leaves an if
DEF_VAR A
IF 1 == 1 THEN
GOTO OUT:
ENDIF
A = 1
OUT: A = 2
END
