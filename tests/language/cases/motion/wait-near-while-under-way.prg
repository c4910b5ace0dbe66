3.1
Wait near while under way
PTP F1 -391 251 -200
WAIT_NEAR ALL
END
