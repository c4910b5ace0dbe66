3.1
Acceleration rate zero
REM one
SET_A_MAX_RATE F1 0
END
