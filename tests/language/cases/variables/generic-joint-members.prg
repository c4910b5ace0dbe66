3.1
Generic joint members
DEF_JOINT Q
Q.J3 = 7
Q.J1 = Q.J3
END
