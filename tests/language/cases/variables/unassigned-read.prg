3.1
Unassigned read
DEF_VAR A, B
B = 1
B = A
A = 1
END
