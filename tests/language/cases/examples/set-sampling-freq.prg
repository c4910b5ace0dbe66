3.1
A hundred cycles a second
SET_SAMPLING_FREQ 100
SLEEP 100
END
