3.1
Loop as an ordinary label
GOTO LOOP:
REM skipped
LOOP: END
