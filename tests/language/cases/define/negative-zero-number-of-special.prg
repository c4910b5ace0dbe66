3.2
Negative zero number of special
DEFINE MINUS -20.5
SPECIAL -MINUS 0 1
END
