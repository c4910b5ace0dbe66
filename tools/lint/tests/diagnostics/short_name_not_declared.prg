3.1
A title
DEF_VAR A1
A1 = 1
B1 = A1
END
