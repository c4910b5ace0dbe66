3.1
Count until a key is struck
DEF_VAR N
N = 0
WHILE !KB_HIT
  N += 1
WEND
KEY_IN
MESSAGE %N%
END
