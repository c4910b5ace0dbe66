3.2
A leg that must not move for a while
LOCK F2
PTP_ANGLE J11 10
WAIT_INPOS J11
UNLOCK F2
PTP_ANGLE J21 10             // Invalid control mode while F2 is locked
WAIT_INPOS J21
END
