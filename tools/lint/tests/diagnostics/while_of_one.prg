3.1
A title
while (1) {
PTP F1 R 0 R 0 R 20
WAIT_INPOS ALL
}
END
