3.2
Declared on a line with others
DEF_VAR V
L1: DEFINE A 1 ; V = A
IF V == 1 THEN
DEFINE B 2
ENDIF
V = B
GOTO L2:
V = 0
L2: END
