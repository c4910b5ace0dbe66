3.2
A SpotMicro trots as sticks say: ahead, sideways, turning, or all together

//     front
//    F1 -- F2      GROUP 1  F1 F4
//    F3 -- F4      GROUP 2  F2 F3
//
// VR1 forward, VR2 turn to the left, VR3 to the right: 5 V is rest, less is the other way.
// Without sticks the inputs read 0 V. Then keys walk: W S ahead and back, A D turn, Q E sideways,
// and any other key stops. After a halt request the robot sits down.
//
// Tried in simulation with full sticks, friction 0.5; joints turn 360 deg/s at most:
//                  ahead, side, turn              fastest joint    margin  slip     falls
// with mass        144 mm/s, 56 mm/s, 39 deg/s    207 deg/s (J23)  -       2.5 mm   0
//   5 deg uphill   128 mm/s, 52 mm/s, 38 deg/s    195 deg/s (J13)  -       8.4 mm   0
// Commands of 270 deg/s at most, which its servos turn. Without mass a trot says nothing: all feet count as standing.

DEFINE REST 5     // V of a stick that rests
DEFINE RANGE 5    // V from there to either end
DEFINE DEAD 0.08  // part of it that is rest too
DEFINE NONE 0.5   // V that all three have together when there are none

DEF_VAR SWING, STAND, LIFT, DELAY, LEAN, RAISE, LOWER
DEF_VAR PERIOD, FLIGHT, FIRST, ENOUGH, STANCE, RATE, N, GROUP, STANDS
DEF_VAR VOLTS, STICK, SIZE, PART, ANGLE, TURN, HEIGHT
DEF_POS H1, H2, H3, H4      // where the feet stand at rest
DEF_POS D1, D2              // how far the feet of each group are from there: mm, mm, deg
DEF_POS PUSH, LEVEL, RATES  // the sticks, and how much of them the robot follows: -1 to 1
DEF_POS TOP, GO             // the speed at 1, and that of the body: mm/s, mm/s, deg/s
DEF_POS FROM, AIR           // where the feet in the air come from, and where they are
DEF_POS TICK, PLUS, WAY, MOVE, P

SWING = 100  // ms that a foot is in the air
STAND = 20   // ms that all feet stand between two swings
LIFT = 12    // mm
DELAY = 400  // ms from rest to full speed, and back
LEAN = 14    // mm that the feet stand behind their initial places: below the mass
RAISE = 0    // mm that the body is above its initial height
LOWER = 80   // mm that it sinks to sit
TOP.X = 60   // mm/s
TOP.Y = 150  // mm/s
TOP.Z = 40   // deg/s

TIP_SPEED_UP 255
START_TIMER 0
SLEEP 0           // ends the cycle
PERIOD = @TIMER0  // ms: what a cycle takes
TICK.X = PERIOD / 1000
TICK.Y = TICK.X ; TICK.Z = TICK.X
RATE = PERIOD / DELAY
RATES.X = RATE ; RATES.Y = RATE ; RATES.Z = RATE
FLIGHT = SWING / PERIOD
FLIGHT = INT FLIGHT  // cycles
FIRST = STAND / PERIOD
FIRST = INT FIRST
ENOUGH = FIRST + FLIGHT
STANCE = ENOUGH * 2
STANCE -= FLIGHT  // cycles that a foot stands

INITIAL_POSTURE
WAIT_INPOS ALL
TEACH_POSITION F1 H1 ; H1.Y -= LEAN ; H1.Z -= RAISE
TEACH_POSITION F2 H2 ; H2.Y -= LEAN ; H2.Z -= RAISE
TEACH_POSITION F3 H3 ; H3.Y -= LEAN ; H3.Z -= RAISE
TEACH_POSITION F4 H4 ; H4.Y -= LEAN ; H4.Z -= RAISE
PTP F1 H1
PTP F2 H2
PTP F3 H3
PTP F4 H4
WAIT_INPOS ALL

// It begins when the sticks rest, or when there are none.
MESSAGE let go of the stick
LOOP:
VOLTS = 0
AD_IN VR1 STICK ; VOLTS += STICK ; CALL READ: ; PUSH.Y = STICK
AD_IN VR2 STICK ; VOLTS += STICK ; CALL READ: ; PUSH.Z = STICK
AD_IN VR3 STICK ; VOLTS += STICK ; CALL READ: ; PUSH.X = STICK
SIZE = NORM PUSH
IF VOLTS < NONE GOTO READY:
IF SIZE > 0 GOTO
READY:
MESSAGE ready

PUSH.X = 0 ; PUSH.Y = 0 ; PUSH.Z = 0
LEVEL = PUSH ; GO = PUSH ; FROM = PUSH
D1 = PUSH
D2 = PUSH
GROUP = 1 ; HEIGHT = 0 ; STANDS = 1
N = ENOUGH
DIRECT ALL

// A cycle ends with AD_IN: a stick is read in every third one.
LOOP:
IF VOLTS < NONE THEN
  CALL READ_KEY:
  CALL WALK:
ELSE
  AD_IN VR1 STICK ; CALL READ: ; PUSH.Y = STICK ; CALL WALK:
  AD_IN VR2 STICK ; CALL READ: ; PUSH.Z = STICK ; CALL WALK:
  AD_IN VR3 STICK ; CALL READ: ; PUSH.X = STICK ; CALL WALK:
ENDIF
IF !HALT_REQUEST GOTO
IF STANDS == 0 GOTO

MESSAGE sitting down
TRAJECTORY ALL
REL_PTP F1 0 0 LOWER
REL_PTP F2 0 0 LOWER
REL_PTP F3 0 0 LOWER
REL_PTP F4 0 0 LOWER
WAIT_INPOS ALL
MESSAGE_CLEAR
EXIT

// From volts to -1 ... 1
SUBROUTINE READ:
  STICK -= REST
  STICK /= RANGE
  SIZE = ABS STICK
  IF SIZE < DEAD THEN
    STICK = 0
  ENDIF
  IF HALT_REQUEST THEN
    STICK = 0
  ENDIF
SUBEND

// It ends the cycle, as AD_IN does.
SUBROUTINE READ_KEY:
  IF HALT_REQUEST THEN
    PUSH.X = 0 ; PUSH.Y = 0 ; PUSH.Z = 0
    SLEEP 0
  ELSEIF KB_HIT THEN
    KEY_IN
    PUSH.X = 0 ; PUSH.Y = 0 ; PUSH.Z = 0
    IF VAR_KEY == CHAR_W THEN
      PUSH.Y = 1
    ELSEIF VAR_KEY == CHAR_S THEN
      PUSH.Y = -1
    ELSEIF VAR_KEY == CHAR_A THEN
      PUSH.Z = 1
    ELSEIF VAR_KEY == CHAR_D THEN
      PUSH.Z = -1
    ELSEIF VAR_KEY == CHAR_Q THEN
      PUSH.X = -1
    ELSEIF VAR_KEY == CHAR_E THEN
      PUSH.X = 1
    ENDIF
  ELSE
    SLEEP 0
  ENDIF
SUBEND

// One cycle: the feet follow the speed.
SUBROUTINE WALK:
  CALL FOLLOW:
  IF N >= ENOUGH THEN
    CALL CHANGE:
  ENDIF
  IF STANDS == 0 THEN
    CALL ADVANCE:
  ENDIF
  MOVE = D1 ; MOVE.Z = 0 ; TURN = D1.Z
  IF GROUP == 1 THEN
    MOVE.Z = HEIGHT
  ENDIF
  P = ROT_Z H1 TURN ; P += MOVE ; PTP F1 P
  P = ROT_Z H4 TURN ; P += MOVE ; PTP F4 P
  MOVE = D2 ; MOVE.Z = 0 ; TURN = D2.Z
  IF GROUP == 2 THEN
    MOVE.Z = HEIGHT
  ENDIF
  P = ROT_Z H2 TURN ; P += MOVE ; PTP F2 P
  P = ROT_Z H3 TURN ; P += MOVE ; PTP F3 P
SUBEND

// The speed follows the sticks. Two or three of them together are no faster than one.
SUBROUTINE FOLLOW:
  WAY = PUSH
  SIZE = NORM PUSH
  IF SIZE > 1 THEN
    WAY = UNIT_VECT PUSH
  ENDIF
  WAY -= LEVEL
  SIZE = NORM WAY
  IF SIZE > RATE THEN
    WAY = UNIT_VECT WAY
    WAY *= RATES
  ENDIF
  LEVEL += WAY
  GO = LEVEL * TOP
SUBEND

// The feet in the air have landed: it is the turn of the next ones.
SUBROUTINE CHANGE:
  GROUP += 1
  IF GROUP > 2 THEN
    GROUP = 1
  ENDIF
  IF GROUP == 1 THEN
    FROM = D1
  ELSE
    FROM = D2
  ENDIF
  N = 0 ; STANDS = 0 ; HEIGHT = 0
  // At rest, feet that are at home stay there. When all are, the robot stands.
  SIZE = NORM GO
  IF SIZE == 0 THEN
    SIZE = NORM FROM
    IF SIZE == 0 THEN
      N = ENOUGH
      PART = NORM D1 ; SIZE += PART
      PART = NORM D2 ; SIZE += PART
      IF SIZE == 0 THEN
        STANDS = 1
      ENDIF
    ENDIF
  ENDIF
SUBEND

SUBROUTINE ADVANCE:
  N += 1
  // The floor moves and turns under the body, and with it the feet and the places that they left.
  WAY = GO * TICK
  ANGLE = -WAY.Z
  D1 -= WAY ; D1 = ROT_Z D1 ANGLE
  D2 -= WAY ; D2 = ROT_Z D2 ANGLE
  FROM -= WAY ; FROM = ROT_Z FROM ANGLE
  IF N > FIRST THEN
    IF N <= ENOUGH THEN
      CALL SWING_FEET:
    ENDIF
  ENDIF
SUBEND

// From where they stood to where half of their way on the floor is ahead of them.
SUBROUTINE SWING_FEET:
  PART = STANCE / 2
  PART += ENOUGH
  PART -= N
  PART *= TICK.X
  PLUS.X = PART ; PLUS.Y = PART ; PLUS.Z = PART
  AIR = GO * PLUS
  AIR -= FROM
  PART = N - FIRST
  PART /= FLIGHT
  CALL SMOOTH:
  AIR *= PLUS
  AIR += FROM
  HEIGHT = SIN ANGLE
  HEIGHT *= LIFT
  IF GROUP == 1 THEN
    D1 = AIR
  ELSE
    D2 = AIR
  ENDIF
SUBEND

// From 0 to 1, at rest at both ends
SUBROUTINE SMOOTH:
  ANGLE = PART * 180
  PART = COS ANGLE
  PART = 1 - PART
  PART /= 2
  PLUS.X = PART ; PLUS.Y = PART ; PLUS.Z = PART
SUBEND

END
