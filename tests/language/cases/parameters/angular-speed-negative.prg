3.1
Angular speed negative
REM one
SET_OMEGA_MAX J11 -1
END
