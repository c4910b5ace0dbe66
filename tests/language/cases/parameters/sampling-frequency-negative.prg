3.1
Sampling frequency negative
REM one
SET_SAMPLING_FREQ -50
END
