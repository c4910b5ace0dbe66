3.2
A leg that must not turn far for a while
SET_LIMIT J11 -20 20
PTP_ANGLE J11 15
WAIT_INPOS J11
RESET_LIMIT J11
PTP_ANGLE J11 30             // Out of reach J11 under the limits
WAIT_INPOS J11
END
