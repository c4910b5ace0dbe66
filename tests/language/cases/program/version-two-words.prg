3.1
A program of the days before declarations
VAR01 = 10.0
A_MAX F1 500
PTP F1 POS01
WAIT_NEAR F1 10.0
COMPLIANCE F1 1 2 3
END
