3.1
Emergency on again
EMG_OFF
EMG_ON
PTP F1 100 -100 0
END
