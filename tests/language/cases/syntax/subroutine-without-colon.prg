3.1
subroutine without colon
GOTO L1:
SUBROUTINE S1
SUBEND
L1: CALL S1:
END
