3.1
key variable never filled
IF VAR_KEY == 1 GOTO L1:
L1:
SLEEP VAR_KEY
END
