3.1
Press a finger onto the floor with a torque
DEF_VAR Y
DEF_POS P
TORQUE J11 8                 // mN m
SLEEP 500
TORQUE J11 R 4               // 4 more: 12
SLEEP 200
TEACH_POSITION F1 P
Y = P.Y
MESSAGE the fingertip is at %Y.0% mm
NO_COMPLIANCE J11
END
