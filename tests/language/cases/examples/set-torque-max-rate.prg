3.1
A tenth of the torque, so that a finger is easily stopped
DEF_VAR T
SET_TORQUE_MAX_RATE ALL 10
TORQUE J21 200               // asks for more
SLEEP 50
TEACH_TORQUE J21 T
MESSAGE J21 gives %T.1% mN m
NO_COMPLIANCE F2
END
