3.1
faulty statements excuse their names
DEF_VAR M, B, C, D
PTP F9 M 1 2
SLEEP 1 B
C = = 1
FROB D
END
