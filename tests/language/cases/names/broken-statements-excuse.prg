3.1
broken statements excuse
DEF_VAR A B C
A = B + C + 1
PTP X1 A B C
END
