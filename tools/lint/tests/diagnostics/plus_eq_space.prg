3.1
A title
DEF_VAR N
N = 1
N + = 3
MESSAGE %N%
END
