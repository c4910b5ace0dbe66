2.0
A program of version 2
PTP F1 POS01
END
