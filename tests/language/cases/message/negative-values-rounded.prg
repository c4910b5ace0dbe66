3.1
Negative values rounded
DEF_VAR A
A = -1.25
MESSAGE %A.1%
A = -0.001
MESSAGE %A.2%
A = -12.5
MESSAGE %A.3%
END
