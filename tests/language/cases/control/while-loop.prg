3.1
While loop
DEF_VAR N
N = 0
WHILE N < 2
N += 1
WEND
END
