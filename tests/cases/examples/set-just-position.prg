3.1
Wait until the foot is within half a millimetre
SET_JUST_POSITION F1 0.5
PTP F1 -391 251 -180
WAIT_INPOS F1
END
