3.1
A title
PTP F5 1 2 3
END
