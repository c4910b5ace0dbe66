3.1
Emergency key in a waiting step
SLEEP 1000
END
