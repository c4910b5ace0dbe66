3.1
All feet at a quarter of their speed and acceleration
DEF_VAR Y
DEF_POS P
SET_A_MAX_RATE ALL 25
SET_V_MAX_RATE ALL 25
PTP F1 -391 251 -180
SLEEP 700
TEACH_POSITION F1 P
Y = P.Y - 201
MESSAGE after 0.7 s it has come %Y.1% mm
WAIT_INPOS F1
END
