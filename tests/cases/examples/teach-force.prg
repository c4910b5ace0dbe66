3.1
Read the force that was asked for
DEF_VAR Z
DEF_POS F
FORCE F1 0 0 -20
SLEEP 100
TEACH_FORCE F1 F
Z = F.Z
MESSAGE it pushes with %Z.1% N
NO_COMPLIANCE F1
END
