3.1
Lever without stiffness
SPECIAL 1
SPECIAL 2
END
