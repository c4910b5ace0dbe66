3.1
A tenth of the torque, so that a finger is easily stopped
SET_TORQUE_MAX_RATE ALL 10
REL_PTP_ANGLE F2 0 10 -10
WAIT_INPOS F2
END
