3.1
The arc that a foot draws, and back
DEF_VAR RAD, ARC, DEG
RAD = DEG2RAD 30
ARC = RAD * 290              // the leg is 290 mm long
DEG = RAD2DEG RAD
MESSAGE %ARC.1% mm for %DEG.1% deg
END
