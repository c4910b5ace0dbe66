3.1
Two feet at once, and go on when both have arrived
PTP F1 -391 251 -180
PTP F4 391 -251 -180
WAIT_INPOS ALL
MESSAGE both are there
END
