3.2
Runs into a subroutine
REM
SUBROUTINE S:
REM
SUBEND
END
