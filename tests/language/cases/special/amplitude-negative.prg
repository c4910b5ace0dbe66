3.1
Amplitude negative
SPECIAL 13 1 0
SPECIAL 13 1 -0.5
END
