3.2
Opener without closer
START_THREAD T:
EXIT
THREAD T:
REM
END
