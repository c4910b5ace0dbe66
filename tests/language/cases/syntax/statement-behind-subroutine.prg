3.1
statement behind subroutine
GOTO L1:
SUBROUTINE S1: SLEEP 20
SUBEND
L1: CALL S1:
END
