3.1
A title
DEF_VAR N
N = 1
if (N == 1) {
  ALL_STOP
} else {
  SLEEP 100
}
END
