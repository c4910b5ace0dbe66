3.1
A title
DEF_VAR N
N = 1
N =+1
SLEEP N
END
