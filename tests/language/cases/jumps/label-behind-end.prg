3.1
label behind end
GOTO L1:
END
L1:
