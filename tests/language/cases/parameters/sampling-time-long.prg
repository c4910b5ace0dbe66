3.1
Sampling time long
REM one
SET_SAMPLING_TIME 1000.5
END
