3.1
A title
DEF_VAR N，M
N = 1
M = N
MESSAGE %M%
END
