3.2
A path given point by point, and a motion back
DEF_VAR ANGLE
DIRECT J11
FOR ANGLE = 1 TO 10
  PTP_ANGLE J11 ANGLE        // the set point is there in this cycle
NEXT ANGLE
TRAJECTORY J11
PTP_ANGLE J11 0
WAIT_INPOS J11
END
