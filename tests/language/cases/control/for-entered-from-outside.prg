3.1
For entered from outside
DEF_VAR I
I = 2
GOTO L1:
FOR I = 1 TO 3
REM body
L1: NEXT
END
