3.1
Closure velocity missing
SPECIAL 5 1
SPECIAL 6 1
END
