3.1
Read a knee, and give one leg the posture of another
DEF_VAR KNEE
DEF_JOINT LEG
TEACH_ANGLE J13 KNEE
MESSAGE the knee is at %KNEE.1% deg
TEACH_ANGLE F2 LEG
PTP_ANGLE F1 LEG
END
