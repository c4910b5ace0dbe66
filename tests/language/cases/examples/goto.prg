3.1
A lamp blinks until a key is struck
LOOP:
  LAMP_ON 1
  SLEEP 60
  LAMP_OFF 1
  SLEEP 60
  IF KB_HIT GOTO DONE:
GOTO                         // the nearest LOOP above
DONE:
END
