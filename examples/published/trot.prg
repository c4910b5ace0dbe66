3.1
An A1 trots: two feet that face each other swing while the other two push

//     front
//    F1 -- F2      ONE    F1 F4
//    F3 -- F4      OTHER  F2 F3

DEF_VAR STRIDES, STRIDE, LIFT, LEAN, N
DEF_POS AHEAD, BACK, UP, DOWN  // moves of a foot
DEF_POS UNDER                  // and of all of them, at first

STRIDES = 8  // swings of each pair, and half a one more at both ends
STRIDE = 30  // mm that the body gains with each, less what its feet slip
LIFT = 20    // mm
LEAN = 12    // mm that its mass is behind the middle of its feet: both pairs carry it alike when they are below it

UP.X = 0 ; UP.Y = 0 ; UP.Z = LIFT
DOWN.X = 0 ; DOWN.Y = 0 ; DOWN.Z = -LIFT
UNDER.X = 0 ; UNDER.Y = -LEAN ; UNDER.Z = 0
AHEAD.X = 0 ; AHEAD.Z = 0
BACK.X = 0 ; BACK.Z = 0

INITIAL_POSTURE
WAIT_INPOS ALL
ALL_STOP
REL_PTP F1 UNDER
REL_PTP F2 UNDER
REL_PTP F3 UNDER
REL_PTP F4 UNDER
ALL_STOP_RELEASE
WAIT_INPOS ALL

// Feet are up for less time than the body takes to fall beside the two that carry it.
SET_V_MAX ALL 1500
SET_A_MAX ALL 12000
AHEAD.Y = STRIDE / 2 ; BACK.Y = -AHEAD.Y
CALL SWING_ONE:
AHEAD.Y = STRIDE ; BACK.Y = -STRIDE
FOR N = 1 TO STRIDES
  MESSAGE stride %N% of %STRIDES%
  CALL SWING_OTHER:
  CALL SWING_ONE:
NEXT N
AHEAD.Y = STRIDE / 2 ; BACK.Y = -AHEAD.Y
CALL SWING_OTHER:
MESSAGE_CLEAR
SLEEP 500
EXIT

SUBROUTINE SWING_ONE:
  REL_PTP F1 UP
  REL_PTP F4 UP
  SLEEP 40
  REL_PTP F1 AHEAD
  REL_PTP F4 AHEAD
  REL_PTP F2 BACK
  REL_PTP F3 BACK
  SLEEP 60
  REL_PTP F1 DOWN
  REL_PTP F4 DOWN
  SLEEP 70
SUBEND

SUBROUTINE SWING_OTHER:
  REL_PTP F2 UP
  REL_PTP F3 UP
  SLEEP 40
  REL_PTP F2 AHEAD
  REL_PTP F3 AHEAD
  REL_PTP F1 BACK
  REL_PTP F4 BACK
  SLEEP 60
  REL_PTP F2 DOWN
  REL_PTP F3 DOWN
  SLEEP 70
SUBEND

END
