3.1
Lift a foot, lower it again, and stop it halfway up
DEF_VAR Z
DEF_POS P
REL_PTP F1 0 0 40
WAIT_INPOS F1
REL_PTP F1 0 0 -40           // from the target, so it is where it was
WAIT_INPOS F1
REL_PTP F1 0 0 40
SLEEP 200
REL_PTP F1 0 0 0             // stop here
WAIT_INPOS F1
TEACH_POSITION F1 P
Z = P.Z + 200
MESSAGE it stopped %Z% mm up
END
