3.1
Special unknown
SPECIAL 14
END
