3.2
Begins with a subroutine
SUBROUTINE S:
REM
SUBEND
END
