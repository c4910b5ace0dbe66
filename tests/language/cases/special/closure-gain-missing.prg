3.1
Closure gain missing
SPECIAL 5
END
