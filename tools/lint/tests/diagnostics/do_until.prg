3.1
A title
DEF_VAR N
N = 0
DO
  N += 1
UNTIL N >= 3
END
