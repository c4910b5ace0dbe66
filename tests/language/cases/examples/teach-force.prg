3.1
How hard a fingertip presses onto the floor
DEF_VAR Y
DEF_POS F
COMPLIANCE_POSITION F1 R 0 -150 0
SLEEP 800
TEACH_FORCE F1 F
Y = F.Y
MESSAGE it pushes with %Y.1% N along y
NO_COMPLIANCE F1
END
