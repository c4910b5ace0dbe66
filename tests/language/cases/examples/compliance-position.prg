3.1
A fingertip that yields: stiff along the floor, soft towards it
DEF_VAR Y
DEF_POS P
SET_POSITION_STIFFNESS F1 0.4 0.05 0
COMPLIANCE_POSITION F1 R 0 -180 0
SLEEP 1000
TEACH_POSITION F1 P
Y = P.Y
MESSAGE the floor stops it at %Y.0% mm
NO_COMPLIANCE F1
END
