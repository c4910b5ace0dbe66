3.1
A title
while (!kbhit()) {
SLEEP 10
}
END
