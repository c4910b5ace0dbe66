3.1
Press a fingertip onto the floor with 1 N, then with 1.5 N
DEF_VAR Y
DEF_POS F
FORCE F1 0 -1 0
SLEEP 300
FORCE F1 R 0 R -0.5 R 0
SLEEP 200
TEACH_FORCE F1 F
Y = F.Y
MESSAGE it presses with %Y.1% N
NO_COMPLIANCE F1
END
