3.1
Lower the lamp's light before the foot arrives
SET_NEAR_POSITION F1 15
LAMP_ON 1
PTP F1 -391 301 -180
WHILE !NEAR_F1
WEND
LAMP_OFF 1
WAIT_INPOS F1
IF NEAR_J11 THEN
  MESSAGE J11 serves the foot: it is near too
ENDIF
IF NEAR_ALL THEN
  MESSAGE so is everything
ENDIF
END
