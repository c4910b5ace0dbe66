3.1
Closure distance negative
SPECIAL 5 1 -2
END
