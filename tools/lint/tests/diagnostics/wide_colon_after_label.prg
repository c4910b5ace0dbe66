3.1
A title
DEF_VAR N
N = 0
L1：
N += 1
IF N < 3 GOTO L1:
END
