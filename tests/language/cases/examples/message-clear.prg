3.1
A message for a moment
MESSAGE stand back
SLEEP 100
MESSAGE_CLEAR
END
