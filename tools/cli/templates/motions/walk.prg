3.1
Walks by leaning away from each foot before it lifts

DEF_VAR STRIDES, STRIDE, QUARTER, LIFT, SETTLE, N, QUIT
DEF_POS G1, G2, G3, G4  // where each foot stands on the floor
DEF_POS BODY            // where the middle of the body is above it
DEF_POS P1, P2, P3, P4  // where each foot is, seen from the body
DEF_POS CENTRE, FOOT    // between the four feet; the foot to lift
DEF_POS SHARE, AWAY     // how far the body leans; where to

STRIDES = 4
STRIDE = 160  // mm
LIFT = 40     // mm
SETTLE = 60   // ms for feet to take their load
SHARE.X = 0.15 ; SHARE.Y = 0.15 ; SHARE.Z = 0
QUARTER = STRIDE / 4
QUIT = 0
SET_A_MAX ALL 1200

// The stance: the belly carries the robot while the feet take their places.
G1.X = -350 ; G1.Y = 240 ; G1.Z = 0
G2.X = 350 ; G2.Y = 240 ; G2.Z = 0
G3.X = -350 ; G3.Y = -240 ; G3.Z = 0
G4.X = 350 ; G4.Y = -240 ; G4.Z = 0
BODY.X = 0 ; BODY.Y = 0 ; BODY.Z = 160
CALL MOVE_BODY:
BODY.Z = 200
CALL MOVE_BODY:
BODY.Z = 260
CALL MOVE_BODY:
CENTRE = BODY

FOR N = 1 TO STRIDES
  IF HALT_REQUEST GOTO HOME:
  CALL KEYS:
  IF QUIT == 1 GOTO HOME:
  MESSAGE stride %N% of %STRIDES%
  CALL STEP_3:
  CALL STEP_1:
  CALL STEP_4:
  CALL STEP_2:
NEXT N

HOME:
BODY = CENTRE
CALL MOVE_BODY:
MESSAGE sitting down
BODY.Z = 200
CALL MOVE_BODY:
EXIT

// Front left
SUBROUTINE STEP_1:
  FOOT = G1
  CALL LEAN:
  REL_PTP F1 0 0 LIFT
  WAIT_NEAR F1
  REL_PTP F1 0 STRIDE 0
  WAIT_NEAR F1
  REL_PTP F1 0 0 -LIFT
  WAIT_INPOS F1
  G1.Y += STRIDE
  CENTRE.Y += QUARTER
SUBEND

// Front right
SUBROUTINE STEP_2:
  FOOT = G2
  CALL LEAN:
  REL_PTP F2 0 0 LIFT
  WAIT_NEAR F2
  REL_PTP F2 0 STRIDE 0
  WAIT_NEAR F2
  REL_PTP F2 0 0 -LIFT
  WAIT_INPOS F2
  G2.Y += STRIDE
  CENTRE.Y += QUARTER
SUBEND

// Rear left
SUBROUTINE STEP_3:
  FOOT = G3
  CALL LEAN:
  REL_PTP F3 0 0 LIFT
  WAIT_NEAR F3
  REL_PTP F3 0 STRIDE 0
  WAIT_NEAR F3
  REL_PTP F3 0 0 -LIFT
  WAIT_INPOS F3
  G3.Y += STRIDE
  CENTRE.Y += QUARTER
SUBEND

// Rear right
SUBROUTINE STEP_4:
  FOOT = G4
  CALL LEAN:
  REL_PTP F4 0 0 LIFT
  WAIT_NEAR F4
  REL_PTP F4 0 STRIDE 0
  WAIT_NEAR F4
  REL_PTP F4 0 0 -LIFT
  WAIT_INPOS F4
  G4.Y += STRIDE
  CENTRE.Y += QUARTER
SUBEND

// The body leans away from the foot that is to lift.
SUBROUTINE LEAN:
  AWAY = CENTRE - FOOT
  AWAY *= SHARE
  BODY = CENTRE + AWAY
  CALL MOVE_BODY:
SUBEND

SUBROUTINE MOVE_BODY:
  P1 = G1 - BODY
  P2 = G2 - BODY
  P3 = G3 - BODY
  P4 = G4 - BODY
  ALL_STOP
  PTP F1 P1
  PTP F2 P2
  PTP F3 P3
  PTP F4 P4
  ALL_STOP_RELEASE
  WAIT_INPOS ALL
  SLEEP SETTLE
SUBEND

// F faster, S slower, Q stop after this stride
SUBROUTINE KEYS:
  IF KB_HIT THEN
    KEY_IN
    IF VAR_KEY == CHAR_F THEN
      SET_V_MAX_FAST ALL
    ELSEIF VAR_KEY == CHAR_S THEN
      SET_V_MAX_SLOW ALL
    ELSEIF VAR_KEY == CHAR_Q THEN
      QUIT = 1
    ENDIF
  ENDIF
SUBEND
END
