3.1
Initial posture waits for rest
PTP F1 -391 301 -150
SLEEP 200
INITIAL_POSTURE
END
