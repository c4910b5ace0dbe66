3.1
All feet at a quarter of their speed and acceleration
SET_A_MAX_RATE ALL 25
SET_V_MAX_RATE ALL 25
PTP F1 -391 251 -180
WAIT_INPOS F1
END
