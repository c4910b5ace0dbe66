3.1
Logs and built ins of generic: forms that run
LOG_START
LOG_STOP
LOG_ONE_SHOT
OUTPUT_VARIABLES
EMG_OFF
EMG_ON
END
