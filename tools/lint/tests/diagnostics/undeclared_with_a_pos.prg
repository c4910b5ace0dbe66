3.1
What it is added to is a POS
DEF_POS P
P.X = -391 ; P.Y = 201 ; P.Z = -150
STEP1 = P
PTP F1 P
END
