3.1
Limit before the step
DEF_VAR A
REM one
A = 1 / 0
END
