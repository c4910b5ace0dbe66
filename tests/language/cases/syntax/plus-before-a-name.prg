3.1
plus before a name
DEF_VAR A
A = 20
A = +A
A = A + +1
SLEEP A
END
