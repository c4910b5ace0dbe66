3.1
Frequency missing
SPECIAL 16
END
