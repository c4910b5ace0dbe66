3.1
Sampling frequency low
REM one
SET_SAMPLING_FREQ 0.9
END
