3.1
openers without closer
DEF_VAR I
I = 1
IF I == 1 THEN
WHILE I == 1
REPEAT
FOR I = 1 TO 2
END
