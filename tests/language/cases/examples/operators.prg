3.1
The middle between two places
DEF_VAR Y, Z
DEF_POS P, Q, MID, TWO
P.X = -391
P.Y = 101
P.Z = -180
Q.X = -391
Q.Y = 301
Q.Z = -160
TWO.X = 2
TWO.Y = 2
TWO.Z = 2
MID = P + Q
MID = MID / TWO              // member by member
PTP F1 MID
Y = MID.Y
Z = MID.Z
MESSAGE its y is %Y%, its z %Z%
END
