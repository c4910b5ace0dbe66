3.1
Generic torque max negative
REM one
SET_TORQUE_MAX J11 -1
END
