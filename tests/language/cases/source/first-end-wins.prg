3.1
first end wins
GOTO L1:
END
L1:
END
