3.1
Else behind for
DEF_VAR I, A
IF 1 == 1 THEN
FOR I = 2 TO 1
A = 1
NEXT
ELSE
A = 2
ENDIF
END
