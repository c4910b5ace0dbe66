3.1
Emergency switches
EMG_OFF
EMG_ON
EMG_ON
EMG_OFF
END
