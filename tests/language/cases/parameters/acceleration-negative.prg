3.1
Acceleration negative
REM one
SET_A_MAX F1 -1
END
