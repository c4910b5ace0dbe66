3.1
Stand up, look around, and sit down
DEF_VAR Z
DEF_POS P
STAND_UP 50
SLEEP 500
TEACH_POSITION F1 P
Z = 0 - P.Z
MESSAGE the body is %Z% mm above the floor
SIT_DOWN 50
END
