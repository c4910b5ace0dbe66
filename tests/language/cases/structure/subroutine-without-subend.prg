3.1
subroutine without subend
EXIT
SUBROUTINE S1:
REM nothing
END
