3.1
Acceleration negative of all
REM one
SET_A_MAX ALL -0.001
END
