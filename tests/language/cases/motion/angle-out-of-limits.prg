3.1
Angle out of limits
REM one
PTP_ANGLE J11 70
END
