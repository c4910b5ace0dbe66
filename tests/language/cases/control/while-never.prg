3.1
While never
DEF_VAR N
WHILE 1 == 2
N = 1
WEND
END
