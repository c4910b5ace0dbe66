3.1
Limit of cycles
L1: GOTO L1:
END
