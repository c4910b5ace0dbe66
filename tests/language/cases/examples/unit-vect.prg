3.1
30 mm in a direction that is given by a point
DEF_VAR Y, Z
DEF_POS WAY, LENGTH
WAY.X = 0
WAY.Y = 300
WAY.Z = 400
LENGTH.X = 30
LENGTH.Y = 30
LENGTH.Z = 30
WAY = UNIT_VECT WAY          // (0, 0.6, 0.8)
WAY *= LENGTH
REL_PTP F1 WAY
Y = WAY.Y
Z = WAY.Z
MESSAGE %Y.1% mm forward, %Z.1% mm up
END
