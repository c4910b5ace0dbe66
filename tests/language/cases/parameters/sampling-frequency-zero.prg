3.1
Sampling frequency zero
REM one
SET_SAMPLING_FREQ 0
END
