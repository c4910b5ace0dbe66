3.1
Lift a foot until a key is hit
L1:
PTP F1 R 0 R 0 R 20
WAIT_INPOS ALL
IF !KB_HIT GOTOL1:
END
