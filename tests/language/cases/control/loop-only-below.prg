3.1
LOOP stands only below the jump
GOTO LOOP:
REM skipped
LOOP: END
