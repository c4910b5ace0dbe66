3.1
Joint command on a free leg
PTP_ANGLE J11 20
WAIT_NEAR J12
END
