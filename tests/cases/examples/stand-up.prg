3.1
Stand up, look around, and sit down
STAND_UP 50
SLEEP 500
SIT_DOWN 50
END
