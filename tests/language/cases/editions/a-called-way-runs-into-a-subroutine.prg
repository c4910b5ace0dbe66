3.2
A called way runs into a subroutine
GOSUB L:
EXIT
L: REM
SUBROUTINE S:
SUBEND
END
