3.1
Struct updates
DEF_JOINT Q, R1
Q.J1 = 1
Q.J2 = 2
Q.J3 = 4
R1 = Q
Q += R1
Q *= R1
Q /= R1
Q -= Q - R1
END
