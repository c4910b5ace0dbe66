3.1
Out of reach with emergency off
EMG_OFF
PTP F1 100 -100 0
REM one
END
