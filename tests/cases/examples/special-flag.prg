3.1
Go on when native code says so
REPEAT
  SLEEP 100
UNTIL !SPECIAL_FLAG0
MESSAGE the flag is down
END
