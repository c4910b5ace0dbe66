3.1
A title
PTP F1 R 50 0 0
END
