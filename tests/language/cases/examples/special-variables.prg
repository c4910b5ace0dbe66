3.2
Stop a foot as soon as it is 20 mm up
REL_PTP F1 0 0 40
WHILE @POS_F1.Z < -180
WEND
REL_PTP F1 0 0 0
WAIT_INPOS F1
MESSAGE the foot rests at %@POS_F1%
END
