3.2
A joint that is locked
LOCK J12
SIT_DOWN 10
END
