3.1
Graph neither on nor off
SPECIAL 20 0 1
SPECIAL 20 0 2
END
