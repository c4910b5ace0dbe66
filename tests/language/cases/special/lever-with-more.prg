3.1
Lever with more
SPECIAL 1
SPECIAL 2 2 0
END
