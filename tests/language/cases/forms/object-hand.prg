3.1
The hand finds an object
EMG_OFF
DETECT_OBJECT 1
END
