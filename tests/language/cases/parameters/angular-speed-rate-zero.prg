3.1
Angular speed rate zero
REM one
SET_OMEGA_MAX_RATE J11 0
END
