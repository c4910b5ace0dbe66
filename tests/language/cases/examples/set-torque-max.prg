3.1
No joint gives more than 30 mN m
DEF_VAR T
SET_TORQUE_MAX ALL 30
FORCE F1 0 -1 0              // asks for more
SLEEP 300
TEACH_TORQUE J11 T
MESSAGE J11 gives %T.1% mN m
NO_COMPLIANCE F1
END
