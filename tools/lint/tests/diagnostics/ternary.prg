3.1
A title
DEF_VAR A, B
A = 1
B = A > 0 ? 1 : 2
SLEEP B
END
