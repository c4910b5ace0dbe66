3.1
Struct read needs every member
DEF_JOINT Q, R1
Q.J1 = 1
Q.J2 = 2
R1 = Q
END
