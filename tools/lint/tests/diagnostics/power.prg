3.1
A title
DEF_VAR I
I = 7 ^ 2
MESSAGE %I%
END
