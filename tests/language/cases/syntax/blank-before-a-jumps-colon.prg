3.1
blank before a jumps colon
L1 :
GOTO L1 :
END
