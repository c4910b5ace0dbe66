3.1
A title
DEF_VAR N
N = 1
WHILE (N < 3) {
  N += 1
}
END
