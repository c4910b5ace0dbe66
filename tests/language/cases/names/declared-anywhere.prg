3.1
declared anywhere
M = 1
P.X = M
M = P.X
DEF_VAR M
Q.J3 = M
M = Q.J3
DEF_POS P ; DEF_JOINT Q
END
