3.1
Amplitude missing
SPECIAL 11 0
END
