3.2
TITAN VIII crawls forward while a thread watches its feeler and locks the leg behind it

// The feeler reaches ahead of the front left foot. While it touches something that leg stays where it stands: the thread
// locks its joints, and no command moves them until it unlocks them. The gait waits before its next step with the leg.

DEFINE TOUCHED 2  // V of the feeler
DEFINE STRIDES 6
DEFINE STRIDE 200  // mm forward, each time all four feet have stepped
DEFINE HALF 100
DEFINE SWAY 40  // mm to either side
DEFINE TWICE 80
DEFINE GROUND -200  // mm below the body, lying
DEFINE CLEAR 50     // mm between belly and floor
DEFINE FLOOR_Z -250
DEFINE TOP -210   // a lifted foot
DEFINE SETTLE 60  // ms for a foot to take its load

DEF_VAR N, FEELER
DEF_VAR HELD            // 1: the leg is locked
DEF_VAR USED            // 1: the gait moves the leg
DEF_POS P1, P2, P3, P4  // where each foot belongs in the robot frame
DEF_POS SHIFT           // how far the feet sweep while the body moves the other way

// Several steps in a cycle: what stands behind a wait happens in one cycle.
TIP_SPEED_UP 16
HELD = 0
USED = 0
SET_A_MAX ALL 1200
SET_JUST_POSITION ALL 1

// The belly carries the robot: the feet may take their places together.
P1.X = -391 - SWAY ; P1.Y = 201 - HALF ; P1.Z = GROUND
P2.X = 391 - SWAY ; P2.Y = 201 ; P2.Z = GROUND
P3.X = -391 - SWAY ; P3.Y = -201 - HALF ; P3.Z = GROUND
P4.X = 391 - SWAY ; P4.Y = -201 ; P4.Z = GROUND
CALL RAISE_ALL:
PTP F1 P1.X P1.Y -160
PTP F2 P2.X P2.Y -160
PTP F3 P3.X P3.Y -160
PTP F4 P4.X P4.Y -160
WAIT_INPOS ALL
CALL TAKE_PLACES:

MESSAGE standing up
STAND_UP CLEAR
P1.Z = FLOOR_Z ; P2.Z = FLOOR_Z ; P3.Z = FLOOR_Z ; P4.Z = FLOOR_Z
SET_V_MAX ALL 300
START_THREAD WATCH:

FOR N = 1 TO STRIDES
  IF HALT_REQUEST GOTO FINISH:
  MESSAGE stride %N% of %STRIDES%

  CALL SWING_F3:
  CALL SWING_F1:
  SHIFT.X = TWICE ; SHIFT.Y = -HALF ; SHIFT.Z = 0
  CALL MOVE_BODY:

  CALL SWING_F4:
  CALL SWING_F2:
  SHIFT.X = -TWICE
  CALL MOVE_BODY:
NEXT N

FINISH:
CALL USE_LEG:
STOP_THREAD WATCH:
MESSAGE sitting down
SIT_DOWN CLEAR
CALL RAISE_ALL:
PTP F1 -391 201 -160
PTP F2 391 201 -160
PTP F3 -391 -201 -160
PTP F4 391 -201 -160
WAIT_INPOS ALL
INITIAL_POSTURE
WAIT_INPOS ALL
MESSAGE_CLEAR
EXIT

// Reads the feeler in every cycle, after the gait has had its turn.
THREAD WATCH:
LOOK: AD_IN ANTENNA FEELER
  IF FEELER > TOUCHED THEN
    IF HELD == 1 GOTO LOOK:
    IF USED == 1 GOTO LOOK:
    LOCK F1
    HELD = 1
    START_TIMER 0
    MESSAGE F1 is locked at %@POS_F1.0%
  ELSEIF HELD == 1 THEN
    UNLOCK F1
    HELD = 0
    F_MESSAGE F1 was locked for %@TIMER0.0% ms\n
  ENDIF
  GOTO LOOK:
THREADEND

// Waits until the leg is free, and takes it. SLEEP ends a turn, so the question and the answer are in one turn of
// the gait: the thread cannot lock the leg between them.
SUBROUTINE USE_LEG:
ASK: SLEEP 0
  IF HELD == 1 GOTO ASK:
  USED = 1
SUBEND

// Front left
SUBROUTINE SWING_F1:
  CALL USE_LEG:
  PTP F1 P1.X P1.Y TOP
  WAIT_NEAR F1
  P1.Y += STRIDE
  PTP F1 P1.X P1.Y TOP
  WAIT_INPOS F1
  PTP F1 P1
  WAIT_INPOS F1
  USED = 0
  SLEEP SETTLE
SUBEND

// Front right
SUBROUTINE SWING_F2:
  PTP F2 P2.X P2.Y TOP
  WAIT_NEAR F2
  P2.Y += STRIDE
  PTP F2 P2.X P2.Y TOP
  WAIT_INPOS F2
  PTP F2 P2
  WAIT_INPOS F2
  SLEEP SETTLE
SUBEND

// Rear left
SUBROUTINE SWING_F3:
  PTP F3 P3.X P3.Y TOP
  WAIT_NEAR F3
  P3.Y += STRIDE
  PTP F3 P3.X P3.Y TOP
  WAIT_INPOS F3
  PTP F3 P3
  WAIT_INPOS F3
  SLEEP SETTLE
SUBEND

// Rear right
SUBROUTINE SWING_F4:
  PTP F4 P4.X P4.Y TOP
  WAIT_NEAR F4
  P4.Y += STRIDE
  PTP F4 P4.X P4.Y TOP
  WAIT_INPOS F4
  PTP F4 P4
  WAIT_INPOS F4
  SLEEP SETTLE
SUBEND

// All four feet sweep by SHIFT; they set out in one cycle, behind the wait of USE_LEG.
SUBROUTINE MOVE_BODY:
  P1 += SHIFT
  P2 += SHIFT
  P3 += SHIFT
  P4 += SHIFT
  CALL USE_LEG:
  PTP F1 P1
  PTP F2 P2
  PTP F3 P3
  PTP F4 P4
  WAIT_INPOS ALL
  USED = 0
  SLEEP SETTLE
SUBEND

SUBROUTINE RAISE_ALL:
  REL_PTP F1 0 0 40
  REL_PTP F2 0 0 40
  REL_PTP F3 0 0 40
  REL_PTP F4 0 0 40
  WAIT_INPOS ALL
SUBEND

SUBROUTINE TAKE_PLACES:
  PTP F1 P1
  PTP F2 P2
  PTP F3 P3
  PTP F4 P4
  WAIT_INPOS ALL
  SLEEP SETTLE
SUBEND

END
