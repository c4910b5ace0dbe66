3.1
Angular acceleration rate negative
REM one
SET_OMEGA_DOT_MAX_RATE ALL -50
END
