3.1
Angular acceleration negative
REM one
SET_OMEGA_DOT_MAX J11 -1
END
