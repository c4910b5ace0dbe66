3.1
Sampling time short
REM one
SET_SAMPLING_TIME 0.99
END
