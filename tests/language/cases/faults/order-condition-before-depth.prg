3.1
Order condition before depth
DEF_VAR N, U
N = 0
L1: N += 1
IF N <= 10 GOSUB L1:
IF U == 1 GOSUB L1:
U = 1
END
