3.1
Wait near under velocity control
VEL_CONTROL F1 0 10 0
WAIT_INPOS F1
WAIT_NEAR F1
END
