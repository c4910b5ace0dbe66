3.1
Lever stiffness negative
SPECIAL 1 0
SPECIAL 2 -2
END
