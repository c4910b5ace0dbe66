3.1
A title
DEF_VAR N
N = 1
N =
MESSAGE %N%
END
