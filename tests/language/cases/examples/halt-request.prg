3.1
Walk on the spot until somebody asks to halt, and end with the foot down
DEF_VAR N
N = 0
LOOP:
  REL_PTP F1 0 0 30
  WAIT_INPOS F1
  REL_PTP F1 0 0 -30
  WAIT_INPOS F1
  N += 1
IF !HALT_REQUEST GOTO
MESSAGE halted after %N% steps
END
