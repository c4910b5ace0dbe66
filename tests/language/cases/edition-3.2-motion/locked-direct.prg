3.2
A joint that is locked
LOCK J12
DIRECT F1
END
