3.1
Sampling frequency high
REM one
SET_SAMPLING_FREQ 1001
END
