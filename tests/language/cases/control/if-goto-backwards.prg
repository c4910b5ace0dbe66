3.1
If goto backwards
DEF_VAR N
N = 2
L1: N -= 1
IF N > 0 GOTO L1:
END
