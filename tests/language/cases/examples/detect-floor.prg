3.1
Put a foot on ground of unknown height
DEF_VAR Z
DEF_POS P
REL_PTP F1 0 0 40
WAIT_INPOS F1
DETECT_FLOOR F1 1
TEACH_POSITION F1 P
Z = P.Z
MESSAGE the ground is at %Z% mm
END
