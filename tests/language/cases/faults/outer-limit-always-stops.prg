3.1
Outer limit always stops
EMG_OFF
SLEEP 100
END
