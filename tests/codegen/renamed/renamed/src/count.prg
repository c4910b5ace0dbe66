3.1
Counts to three
DEF_VAR N
N = 0
WHILE N < 3
  N += 1
WEND
END
