3.1
Label and rem are nops
REM the first step
L1:
REM the third step
END
