3.1
Lever begun with a negative stiffness
SPECIAL 1 -2
END
