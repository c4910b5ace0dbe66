3.2
Demanded first edition
LOCK F1
END
