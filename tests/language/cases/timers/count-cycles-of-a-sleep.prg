3.2
Count cycles of a sleep
DEF_VAR A
START_TIMER 4
SLEEP 90
A = @TIMER4
END
