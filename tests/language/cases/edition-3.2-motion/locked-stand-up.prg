3.2
A joint that is locked
LOCK J12
STAND_UP 10
END
