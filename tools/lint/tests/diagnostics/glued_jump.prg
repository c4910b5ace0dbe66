3.1
Lift a foot again and again
L1:
PTP F1 R 0 R 0 R 20
WAIT_INPOS ALL
GOTOL1:
END
