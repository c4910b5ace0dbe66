3.1
Closure not begun
SPECIAL 6 1 -5
END
