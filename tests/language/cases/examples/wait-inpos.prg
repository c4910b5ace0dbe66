3.1
Two feet at once, and go on when both have arrived
DEF_VAR Y
DEF_POS P
PTP F1 -391 251 -180
PTP F4 391 -251 -180
WAIT_INPOS ALL
TEACH_POSITION F1 P
Y = P.Y
MESSAGE both are there: F1 at %Y% mm
END
