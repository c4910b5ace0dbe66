3.1
A title
DEF_VAR A(10)
A(1) = 3
END
