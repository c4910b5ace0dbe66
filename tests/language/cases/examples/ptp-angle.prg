3.1
Lift one leg by its joints and bend the knee of another
DEF_VAR KNEE
PTP_ANGLE F1 0 30 90
PTP_ANGLE J33 R 10           // 10 deg more than it has now
WAIT_INPOS ALL
TEACH_ANGLE J33 KNEE
MESSAGE the knee is at %KNEE% deg
END
