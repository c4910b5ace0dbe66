3.1
Joint limit ignored
EMG_OFF
SLEEP 100
END
