3.1
Wait until the foot is within half a millimetre
DEF_VAR Y
DEF_POS P
SET_JUST_POSITION F1 0.5
PTP F1 -391 251 -180
WAIT_INPOS F1
TEACH_POSITION F1 P
Y = P.Y
MESSAGE it is at %Y.1% mm
END
