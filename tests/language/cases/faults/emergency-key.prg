3.1
Emergency key
REM one
REM two
L1: GOTO L1:
END
