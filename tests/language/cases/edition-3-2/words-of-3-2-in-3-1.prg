3.1
Commands of the next edition
DEFINE TEN 10
START_TIMER 1
F_MESSAGE text
DIRECT ALL
END
