3.2
A joint that is locked
LOCK J12
PTP_ANGLE J12 1
END
