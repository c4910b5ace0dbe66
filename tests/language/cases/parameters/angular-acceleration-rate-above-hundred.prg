3.1
Angular acceleration rate above hundred
REM one
SET_OMEGA_DOT_MAX_RATE J43 200
END
