3.1
A PhantomX walks: two tripods take turns, one steps while the other carries

//         front
//    F1 -------- F2      LEFT   F1 F4 F5, with two feet on the left
//    F3 -------- F4      RIGHT  F2 F3 F6, with two feet on the right
//    F5 -------- F6

DEF_VAR STRIDES, STRIDE, LIFT, N
DEF_POS UP, DOWN, AHEAD, BACK  // moves of a foot
DEF_POS LEFT, RIGHT            // what the feet of each tripod are to do next

STRIDES = 5  // steps of either tripod
STRIDE = 50  // mm that the body gains with each step
LIFT = 30    // mm

UP.X = 0 ; UP.Y = 0
DOWN.X = 0 ; DOWN.Y = 0
AHEAD.X = 0 ; AHEAD.Z = 0
BACK.X = 0 ; BACK.Z = 0

// From here on every foot moves by so much from where it was commanded to be.
INITIAL_POSTURE
WAIT_INPOS ALL

UP.Z = LIFT ; DOWN.Z = -LIFT

// The feet stand side by side: the first and the last step are half as long.
AHEAD.Y = STRIDE / 2 ; BACK.Y = -AHEAD.Y
CALL STEP_LEFT:
AHEAD.Y = STRIDE ; BACK.Y = -STRIDE
FOR N = 1 TO STRIDES
  IF HALT_REQUEST GOTO HALT:
  MESSAGE stride %N% of %STRIDES%
  CALL STEP_RIGHT:
  CALL STEP_LEFT:
NEXT N

HALT:
AHEAD.Y = STRIDE / 2 ; BACK.Y = -AHEAD.Y
CALL STEP_RIGHT:

MESSAGE sitting down
INITIAL_POSTURE
WAIT_INPOS ALL
MESSAGE_CLEAR
EXIT

// Up, over, down. While its feet are up the others sweep back, and the body goes forward.
SUBROUTINE STEP_LEFT:
  LEFT = UP
  CALL MOVE_LEFT:
  WAIT_INPOS ALL
  LEFT = AHEAD ; RIGHT = BACK
  CALL MOVE_BOTH:
  LEFT = DOWN
  CALL MOVE_LEFT:
  WAIT_INPOS ALL
SUBEND

SUBROUTINE STEP_RIGHT:
  RIGHT = UP
  CALL MOVE_RIGHT:
  WAIT_INPOS ALL
  RIGHT = AHEAD ; LEFT = BACK
  CALL MOVE_BOTH:
  RIGHT = DOWN
  CALL MOVE_RIGHT:
  WAIT_INPOS ALL
SUBEND

// A step takes a cycle, so six commands would set out one after the other and
// drag the feet that carry: the hold lets all start together.
SUBROUTINE MOVE_BOTH:
  ALL_STOP
  CALL MOVE_LEFT:
  CALL MOVE_RIGHT:
  ALL_STOP_RELEASE
  WAIT_INPOS ALL
SUBEND

SUBROUTINE MOVE_LEFT:
  REL_PTP F1 LEFT
  REL_PTP F4 LEFT
  REL_PTP F5 LEFT
SUBEND

SUBROUTINE MOVE_RIGHT:
  REL_PTP F2 RIGHT
  REL_PTP F3 RIGHT
  REL_PTP F6 RIGHT
SUBEND

END
