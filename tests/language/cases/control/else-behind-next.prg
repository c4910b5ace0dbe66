3.1
Else behind next
DEF_VAR I, A
IF 1 == 1 THEN
FOR I = 1 TO 1
NEXT
ELSE
A = 1
ENDIF
END
