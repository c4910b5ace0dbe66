3.1
Twice as many cycles in the same time
SET_SAMPLING_TIME 10
SLEEP 100
END
