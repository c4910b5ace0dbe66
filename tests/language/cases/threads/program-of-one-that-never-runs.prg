3.2
Program of one that never runs
REM
EXIT
THREAD T:
REM
THREADEND
END
