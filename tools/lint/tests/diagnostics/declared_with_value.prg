3.1
A title
DEF_VAR N = 0
N = N + 1
END
