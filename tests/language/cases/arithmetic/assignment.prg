3.1
Assignment
DEF_VAR A, B
A = 5.
B = .5
A = -B
B = +2
A = -1.25E2
B = 0
B = -B
END
