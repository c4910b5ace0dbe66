3.1
Begin from a posture that is known
PTP_ANGLE F1 20 30 60        // wherever the robot was
WAIT_INPOS F1
INITIAL_POSTURE
WAIT_INPOS ALL
MESSAGE ready
END
