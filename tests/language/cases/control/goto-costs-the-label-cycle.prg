3.1
Goto costs the label cycle
GOTO L1:
REM skipped
L1:
END
