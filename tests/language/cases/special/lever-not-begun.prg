3.1
Lever not begun
SPECIAL 2 2
END
