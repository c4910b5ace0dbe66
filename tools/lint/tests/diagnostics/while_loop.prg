3.1
A title
DEF_VAR N
N = 0
WHILE N < 3
  N += 1
LOOP
END
