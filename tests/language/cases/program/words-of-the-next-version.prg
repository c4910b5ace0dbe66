3.1
Words of the next version
LOCK F1
DIRECT
START_TIMER 1
END
