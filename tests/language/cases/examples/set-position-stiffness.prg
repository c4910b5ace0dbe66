3.1
A fingertip that is soft against the floor, and softer still along it
DEF_VAR Y
DEF_POS F
SET_POSITION_STIFFNESS ALL 0.02 0.05 0
COMPLIANCE_POSITION F1 R 0 -160 0
SLEEP 700
TEACH_FORCE F1 F
Y = F.Y
MESSAGE it presses with %Y.1% N
NO_COMPLIANCE F1
END
