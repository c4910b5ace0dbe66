3.1
Angular speed rate above hundred
REM one
SET_OMEGA_MAX_RATE J43 200
END
