3.2
Ways wait for other errors
DEF_VAR A B
A = B
B = A
NOPE 1
END
