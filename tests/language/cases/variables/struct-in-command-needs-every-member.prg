3.1
Struct in command needs every member
DEF_POS P
P.X = -391
P.Y = 201
PTP F1 P
END
