3.1
A lamp shines while the foot moves
LAMP_ON 3
REL_PTP F1 0 0 30
WAIT_INPOS F1
LAMP_OFF 3
END
