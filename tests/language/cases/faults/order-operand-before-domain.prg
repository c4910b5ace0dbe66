3.1
Order operand before domain
DEF_VAR A, B
B = A / 0
A = 1
END
