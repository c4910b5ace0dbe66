3.1
Sampling time negative
REM one
SET_SAMPLING_TIME -20
END
