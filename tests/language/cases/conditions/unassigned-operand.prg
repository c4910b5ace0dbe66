3.1
Unassigned operand
DEF_VAR A
IF A > 0 GOTO L1:
L1: A = 1
END
