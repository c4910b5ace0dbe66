3.1
A title
DEF_VAR I
I = 7 % 3
MESSAGE %I%
END
