3.1
A title
DEF_VAR N
N = 1
IF N == 1 {
  MESSAGE a
}
END
