3.1
Angular acceleration rate zero
REM one
SET_OMEGA_DOT_MAX_RATE J11 0
END
