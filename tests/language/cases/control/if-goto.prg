3.1
If goto
IF 1 == 2 GOTO L1:
IF 1 == 1 GOTO L1:
REM skipped
L1: END
