3.1
Wait near joint uncontrolled
PTP F1 -391 201 -200
WAIT_NEAR J21
END
