3.1
Soft on the way, then stiff where the finger happens to be
DEF_VAR ANGLE
COMPLIANCE_ANGLE F1 R 40 R 0 R 0
SLEEP 300
NO_COMPLIANCE F1
WAIT_INPOS F1
TEACH_ANGLE J11 ANGLE
MESSAGE it stays at %ANGLE% deg
END
