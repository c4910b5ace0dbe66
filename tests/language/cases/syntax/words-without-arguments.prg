3.1
words without arguments
GOSUB L1:
GOTO L2:
L1: RETURN 5
L2: EXIT 0
END
