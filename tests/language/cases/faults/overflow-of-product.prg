3.1
Overflow of product
DEF_VAR A
A = -1E200 * 1E200
END
