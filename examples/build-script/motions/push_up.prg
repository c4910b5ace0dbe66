3.1
Push-ups: the robot rises from its belly and sinks again

DEF_VAR N, TIMES, HEIGHT

TIMES = 3
HEIGHT = 40  // mm; each push-up goes 10 mm higher

FOR N = 1 TO TIMES
  IF HALT_REQUEST GOTO DONE:
  MESSAGE push-up %N%: %HEIGHT% mm
  STAND_UP HEIGHT
  SLEEP 200
  SIT_DOWN HEIGHT
  HEIGHT += 10
NEXT N

DONE:
MESSAGE done
END
