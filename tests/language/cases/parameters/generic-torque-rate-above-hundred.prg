3.1
Generic torque rate above hundred
REM one
SET_TORQUE_MAX_RATE ALL 101
END
