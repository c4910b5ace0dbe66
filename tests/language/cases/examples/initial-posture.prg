3.1
Begin from a posture that is known
DEF_VAR ANGLE
PTP_ANGLE F1 20 30 60        // wherever the robot was
WAIT_INPOS F1
INITIAL_POSTURE
WAIT_INPOS ALL
TEACH_ANGLE J12 ANGLE
MESSAGE ready: J12 is at %ANGLE% deg
END
