3.1
Four operations
DEF_VAR A, B
A = 7
B = A + 2
B = A - 9
B = A * -3
B = A / 2
B=A+B
END
