3.1
Round a corner: the next motion begins before the first has ended
DEF_VAR Y
DEF_POS P
SET_NEAR_POSITION F1 20
PTP F1 -391 251 -160
WAIT_NEAR F1
TEACH_POSITION F1 P
Y = P.Y
MESSAGE it turns at %Y% mm
PTP F1 -391 301 -200
WAIT_INPOS F1
END
