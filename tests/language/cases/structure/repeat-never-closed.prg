3.1
repeat never closed
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
GOTO L1:
SLEEP 1
REPEAT
L1:
SLEEP 2
GOTO L1:
END
