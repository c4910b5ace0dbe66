3.1
while never closed
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
GOTO L1:
SLEEP 1
WHILE V == 1
L1:
SLEEP 2
GOTO L1:
END
