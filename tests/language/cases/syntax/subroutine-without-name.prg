3.1
subroutine without name
GOTO L1:
SUBROUTINE
SUBEND
L1:
END
