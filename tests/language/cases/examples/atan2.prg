3.1
The direction of a point behind the robot
DEF_VAR DIR
DEF_POS P
P.X = -100
P.Y = -100
DIR = ATAN2 P.Y P.X
MESSAGE %DIR.1% deg
END
