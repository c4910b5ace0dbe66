3.1
A way turned by a quarter about each axis
DEF_VAR N
DEF_POS FORWARD, WAY
FORWARD.X = 0
FORWARD.Y = 40
FORWARD.Z = 0
WAY = ROT_Z FORWARD 90       // forward becomes left
N = WAY.X
MESSAGE x is %N.1%
WAY = ROT_X FORWARD 90       // forward becomes up
N = WAY.Z
MESSAGE z is %N.1%
WAY = ROT_Y WAY 90           // up becomes right
N = WAY.X
MESSAGE x is %N.1%
END
