3.1
Acceleration rate above hundred
REM one
SET_A_MAX_RATE ALL 100.1
END
