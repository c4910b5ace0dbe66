3.1
Press a foot onto the floor with 20 N, then 30 N
FORCE F1 0 0 -20
SLEEP 200
FORCE F1 R 0 R 0 R -10
SLEEP 200
NO_COMPLIANCE F1
END
