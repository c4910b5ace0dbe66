3.1
Put a foot on ground of unknown height
REL_PTP F1 0 0 40
WAIT_INPOS F1
DETECT_FLOOR F1 1
MESSAGE the foot stands
END
