3.1
colon forgotten
L1
GOTO L1:
END
