3.2
Take the time of two pauses, without what is between them
START_TIMER 0
SLEEP 100
STOP_TIMER 0
MESSAGE one takes %@TIMER0% ms
RESTART_TIMER 0
SLEEP 100
STOP_TIMER 0
MESSAGE both take %@TIMER0% ms
RESET_TIMER 0
MESSAGE the timer shows %@TIMER0% ms
END
