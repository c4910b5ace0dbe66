3.1
Asin below minus one
DEF_VAR A
A = ASIN -1.0000001
END
