3.1
Say when the foot has 15 mm left to go
SET_NEAR_POSITION ALL 15
PTP F1 -391 301 -180
WAIT_NEAR F1
MESSAGE nearly there
WAIT_INPOS F1
END
