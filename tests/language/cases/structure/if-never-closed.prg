3.1
if never closed
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
GOTO L1:
SLEEP 1
IF V == 1 THEN
L1:
SLEEP 2
GOTO L1:
END
