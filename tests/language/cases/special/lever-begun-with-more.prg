3.1
Lever begun with more
SPECIAL 1 2
SPECIAL 1 2 0
END
