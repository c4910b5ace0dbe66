3.1
Order struct operands first
DEF_POS P, Q
P.X = 0
P.Y = 0
P.Z = 0
Q.X = 0
Q.Y = 1
P = P / Q
END
