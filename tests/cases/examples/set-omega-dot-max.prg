3.1
Let all joints start and stop gently
SET_OMEGA_DOT_MAX ALL 90
PTP_ANGLE F1 30 20 80
WAIT_INPOS F1
END
