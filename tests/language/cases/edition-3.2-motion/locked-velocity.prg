3.2
A joint that is locked
LOCK J12
VEL_CONTROL F1 0 0 0
END
