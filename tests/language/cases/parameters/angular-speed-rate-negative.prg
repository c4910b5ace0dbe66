3.1
Angular speed rate negative
REM one
SET_OMEGA_MAX_RATE ALL -50
END
