3.1
A TriFinger leads its fingertips round a circle, as if all three held a disc

DEF_VAR STEPS, RADIUS, TURN, EACH, N, X, Y
DEF_POS MOVE  // of all fingertips, from one point of the circle to the next

STEPS = 72   // of one round
RADIUS = 30  // mm

// They begin on the right of the circle; from here on each moves by so much from where it was commanded to be.
INITIAL_POSTURE
WAIT_INPOS ALL

X = RADIUS ; Y = 0
MOVE.Z = 0
EACH = 360 / STEPS
FOR N = 1 TO STEPS
  MESSAGE point %N% of %STEPS%
  TURN = N * EACH
  MOVE.X = COS TURN ; MOVE.Y = SIN TURN
  MOVE.X *= RADIUS ; MOVE.Y *= RADIUS
  MOVE.X -= X ; MOVE.Y -= Y
  X += MOVE.X ; Y += MOVE.Y
  CALL MOVE_ALL:
NEXT N
MESSAGE_CLEAR
EXIT

// A step takes a cycle: the hold lets all start together.
SUBROUTINE MOVE_ALL:
  ALL_STOP
  REL_PTP F1 MOVE
  REL_PTP F2 MOVE
  REL_PTP F3 MOVE
  ALL_STOP_RELEASE
  WAIT_INPOS ALL
SUBEND

END
