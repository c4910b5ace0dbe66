3.1
Turn a joint as far as it goes
DEF_VAR V
EMG_OFF
PTP_ANGLE J11 80             // its limit is 60
SLEEP 2000
TEACH_ANGLE J11 V
MESSAGE it stopped at %V.1% deg
PTP_ANGLE J11 0
WAIT_INPOS J11
EMG_ON
END
