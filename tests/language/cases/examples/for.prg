3.1
Three places in a row, from the rear to the front
DEF_VAR Y
FOR Y = 101 TO 301 STEP 100
  PTP F1 -391 Y -180
  WAIT_INPOS F1
  MESSAGE it is at %Y% mm
NEXT Y
END
