3.1
Frequency negative
SPECIAL 15 0
SPECIAL 15 -1
END
