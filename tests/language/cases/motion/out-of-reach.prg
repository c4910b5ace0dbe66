3.1
Out of reach
PTP F1 100 -100 0
END
