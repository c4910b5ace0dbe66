3.1
to the edge of a block
GOTO L1:
GOTO L3:
GOTO L2:
L1: WHILE KB_HIT
L2: WEND
L3:
END
