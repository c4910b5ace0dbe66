3.1
Closure gain negative
SPECIAL 5 -1 2
END
