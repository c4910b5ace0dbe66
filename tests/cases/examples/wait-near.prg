3.1
Round a corner: the next motion begins before the first has ended
SET_NEAR_POSITION F1 20
PTP F1 -391 251 -160
WAIT_NEAR F1
PTP F1 -391 301 -200
WAIT_INPOS F1
END
