3.1
next of an unknown variable
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
FOR I = 1 TO 2
NEXT K
FOR I = 1 TO K
NEXT I
END
