3.1
A title
ptp f1 1 2 3
wait inpos all
END
