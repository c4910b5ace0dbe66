3.1
Count down
DEF_VAR N
N = 2
WHILE N > 0
  MESSAGE %N%
  N -= 1
WEND
MESSAGE go
END
