3.1
for never closed
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
GOTO L1:
SLEEP 1
FOR I = 1 TO 2
L1:
SLEEP 2
GOTO L1:
END
