3.1
Lifts the front left foot, again and again
DEF_VAR N
FOR N = 1 TO 3
  REL_PTP F1 0 0 60
  WAIT_INPOS F1
  REL_PTP F1 0 0 -60
  WAIT_INPOS F1
  MESSAGE lifted %N%
NEXT N
END
