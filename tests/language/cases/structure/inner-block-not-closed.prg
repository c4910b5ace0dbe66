3.1
inner block not closed
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
FOR I = 1 TO 2
IF V == 1 THEN
NEXT
FOR J = 1 TO 2
NEXT J
WHILE V == 1
REPEAT
IF V == 2 THEN
WEND
END
