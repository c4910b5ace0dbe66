3.1
Out of reach on the way
SET_SAMPLING_TIME 1000
VEL_CONTROL F1 -300 0 0
REM two
REM three
END
