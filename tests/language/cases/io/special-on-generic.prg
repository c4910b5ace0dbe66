3.1
Special on generic
SPECIAL 0
END
