3.1
Int is floor
DEF_VAR A
A = INT 2.5
A = INT -2.5
A = INT -3
A = INT 0.999
A = INT -0.001
A = INT -0.0
END
