3.1
Label named by digits
GOTO 10:
REM skipped
10: END
