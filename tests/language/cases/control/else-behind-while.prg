3.1
Else behind while
DEF_VAR A
IF 1 == 1 THEN
WHILE 1 == 2
A = 1
WEND
ELSE
A = 2
ENDIF
END
