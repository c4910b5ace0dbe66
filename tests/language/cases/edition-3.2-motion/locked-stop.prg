3.2
A joint that is locked
LOCK J12
REL_PTP F1 0 0 0
END
