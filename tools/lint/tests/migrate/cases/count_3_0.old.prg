3.0
Count down
DEF_VAR N, FIRST ; FIRST = 5
FOR N FIRST TO 9    // up, in truth
  MESSAGE %N%, not %f01% ; SLEEP 100
NEXT N
REM a step
SET_NEAR ALL 5.0
WAIT_NEAR J11 3.0
END
