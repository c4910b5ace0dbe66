3.1
Lifts a foot and stays on the other three

DEF_POS G1, G2, G3, G4      // where each foot stands on the floor
DEF_POS BODY                // where the middle of the body is above it
DEF_POS P1, P2, P3, P4      // where each foot is, seen from the body
DEF_POS AWAY, SHARE         // how far the body leans

SHARE.X = 0.15 ; SHARE.Y = 0.15 ; SHARE.Z = 0

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

// Away from the foot that is to lift, by a share of the distance to it.
AWAY = BODY - G3
AWAY *= SHARE
BODY += AWAY
CALL MOVE_BODY:
REL_PTP F3 0 0 40
WAIT_INPOS F3
MESSAGE on three feet
EXIT

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
SUBEND
END
