3.1
TITAN VIII stands, and is pushed from the left for a fifth of a second
// events: 100:push 450 0 0 for 10

STAND_UP 60
WAIT_INPOS ALL
SLEEP 3000
END
