3.1
Leaving loops by goto
DEF_VAR I
FOR I = 1 TO 9
WHILE 1 == 1
GOTO OUT:
WEND
NEXT
OUT: END
