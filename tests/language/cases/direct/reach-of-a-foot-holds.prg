3.2
Reach of a foot holds
DIRECT F1
PTP F1 100 -100 0
END
