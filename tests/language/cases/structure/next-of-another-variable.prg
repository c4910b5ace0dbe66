3.1
next of another variable
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
FOR I = 1 TO 2
NEXT J
FOR I = 1 TO 2
FOR J = 1 TO 2
NEXT I
NEXT J
FOR I = 1 TO 2
NEXT i
END
