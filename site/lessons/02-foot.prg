3.1
Lift the front left foot
DEF_VAR Z
DEF_POS P
REL_PTP F1 0 0 60
TEACH_POSITION F1 P      // where the foot is now
Z = P.Z
MESSAGE at %Z.0% mm
WAIT_INPOS F1
TEACH_POSITION F1 P
Z = P.Z
MESSAGE at %Z.0% mm
END
