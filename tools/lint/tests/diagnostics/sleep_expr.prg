3.1
A title
DEF_VAR N
N = 1
SLEEP N * 2
END
