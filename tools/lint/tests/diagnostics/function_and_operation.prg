3.1
A title
DEF_VAR N
N = SIN 30 + 1
END
