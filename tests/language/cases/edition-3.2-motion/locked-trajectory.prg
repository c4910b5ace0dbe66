3.2
A joint that is locked
LOCK J12
TRAJECTORY J12
END
