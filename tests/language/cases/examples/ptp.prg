3.1
Reach forward with the front left foot, and fast half the way back
DEF_VAR Y
DEF_POS P
PTP F1 -391 301 -180
WAIT_INPOS F1
PTP HS F1 R 0 R -50 -180     // R: from where the foot is now
WAIT_INPOS F1
TEACH_POSITION F1 P
Y = P.Y
MESSAGE the foot is %Y% mm ahead of the middle
END
