3.2
A joint that is locked
LOCK J12
DETECT_FLOOR F1 1
END
