3.1
Friction off and more
SPECIAL 10
SPECIAL 10 0
END
