3.1
Press a fingertip onto the floor with 1 N, then with 1.5 N
FORCE F1 0 -1 0
SLEEP 300
FORCE F1 R 0 R -0.5 R 0
SLEEP 200
NO_COMPLIANCE F1
END
