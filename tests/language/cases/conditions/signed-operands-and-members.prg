3.1
Signed operands and members
DEF_VAR A
DEF_POS P
A = 2
P.Y = -2
IF -A == P.Y GOTO L1:
EXIT
L1: IF -P.Y <> A GOTO BAD:
IF -2 < -A GOTO BAD:
IF A>=-P.Y GOTO L2:
EXIT
L2: IF CHAR_A == 65 GOTO L3:
BAD: EXIT
L3: END
