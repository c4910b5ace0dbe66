3.1
A title
PTP ALL 1 2 3
END
