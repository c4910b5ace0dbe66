3.1
Three places in a row, from behind to the front
DEF_VAR Y
FOR Y = 101 TO 301 STEP 100
  PTP F1 -391 Y -180
  WAIT_INPOS F1
NEXT Y
END
