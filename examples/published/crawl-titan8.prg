3.2
TITAN VIII crawls as sticks say: ahead, sideways, turning, or all together

//     front
//    F1 -- F2      in turn F3 F1 F4 F2
//    F3 -- F4
//
// VR1 forward, VR2 turn to the left, VR3 to the right: 5 V is rest, less is the other way.
// Without sticks the inputs read 0 V. Then keys walk: W S ahead and back, A D turn, Q E sideways,
// and any other key stops. After a halt request the robot sits down.
//
// Tried in simulation with full sticks, friction 0.5; joints turn 360 deg/s at most:
//                  ahead, side, turn          fastest joint    margin  slip
// with mass        89 mm/s, 20 mm/s, 6 deg/s  232 deg/s (J21)  -       1.2 mm
//   5 deg uphill   88 mm/s, 20 mm/s, 6 deg/s  232 deg/s (J21)  -       1.5 mm
// without mass     89 mm/s, 20 mm/s, 6 deg/s  235 deg/s (J21)  23 mm   0.5 mm
//   5 deg uphill   89 mm/s, 20 mm/s, 6 deg/s  235 deg/s (J21)  4 mm    0.2 mm

DEFINE REST 5     // V of a stick that rests
DEFINE RANGE 5    // V from there to either end
DEFINE DEAD 0.08  // part of it that is rest too
DEFINE NONE 0.5   // V that all three have together when there are none
DEFINE CLEAR 0.4  // part of TOP.Y from which the order of the feet follows the direction
DEFINE BACK -0.4

DEF_VAR SWING, SHIFT, LIFT, DELAY, SWAY, REACH, LEAN, RAISE, LOWER
DEF_VAR PERIOD, FLIGHT, FIRST, ENOUGH, RATE, N, GROUP, STANDS
DEF_VAR VOLTS, STICK, SIZE, PART, ANGLE, TURN, HEIGHT
DEF_VAR WORST
DEF_VAR LONG, SHORT, FULL, STRIDE, NEXT_ONE
DEF_POS H1, H2, H3, H4      // where the feet stand at rest
DEF_POS D1, D2, D3, D4      // how far the feet of each group are from there: mm, mm, deg
DEF_POS PUSH, LEVEL, RATES  // the sticks, and how much of them the robot follows: -1 to 1
DEF_POS TOP, GO             // the speed at 1, and that of the body: mm/s, mm/s, deg/s
DEF_POS FROM, AIR           // where the feet in the air come from, and where they are
DEF_POS TICK, PLUS, WAY, MOVE
DEF_POS P1, P2, P3, P4  // where the feet are
DEF_POS SOON, WEIGHT, BRAKE
DEF_POS BODY, OLD, SWAY_TO  // where the body is to lean, where it leans, and where it leaned
DEF_POS HOME, AWAY, HALF, GOAL, LOOK, ONE

SWING = 200     // ms that a foot is in the air
SHIFT = 340     // ms for the body to lean to the other side at rest; a shorter way takes less
LIFT = 30       // mm
DELAY = 1500    // ms from rest to full speed, and back
SWAY = 0.25     // how far the body leans to the middle of the feet that stand: 0 to 1
REACH = 170     // mm that a foot may be ahead of its place, or behind it
WEIGHT.X = 1.7  // mm ahead that are as far for it as one to the side
LEAN = 0        // mm that the feet stand behind their initial places: below the mass
RAISE = 50      // mm that the body is above its initial height
LOWER = 48      // mm that it sinks to sit
TOP.X = 20      // mm/s
TOP.Y = 90      // mm/s
TOP.Z = 6       // deg/s

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
LONG = SHIFT / PERIOD
LONG = INT LONG
SHORT = LONG / 4
SHORT = INT SHORT  // cycles that it takes at least
STRIDE = LONG + FLIGHT
STRIDE *= 4  // cycles in which every foot swings once: an estimate
PART = SWAY / 3
AWAY.X = PART ; AWAY.Y = PART ; AWAY.Z = 0
HALF.X = 0.5 ; HALF.Y = 0.5 ; HALF.Z = 0
WEIGHT.Y = 1
WEIGHT.Z = 0
SOON.X = 0.3 ; SOON.Y = 0.3 ; SOON.Z = 0.3  // s
BRAKE.X = 0.8 ; BRAKE.Y = 0.8 ; BRAKE.Z = 0.8
ONE.X = 1 ; ONE.Y = 1 ; ONE.Z = 1

INITIAL_POSTURE
WAIT_INPOS ALL
TEACH_POSITION F1 H1 ; H1.Y -= LEAN ; H1.Z -= RAISE ; P1 = H1
TEACH_POSITION F2 H2 ; H2.Y -= LEAN ; H2.Z -= RAISE ; P2 = H2
TEACH_POSITION F3 H3 ; H3.Y -= LEAN ; H3.Z -= RAISE ; P3 = H3
TEACH_POSITION F4 H4 ; H4.Y -= LEAN ; H4.Z -= RAISE ; P4 = H4
PTP F1 H1
PTP F2 H2
PTP F3 H3
PTP F4 H4
WAIT_INPOS ALL
WAY = H1 * AWAY
FULL = NORM WAY
FULL *= 2  // mm that the body leans from one side to the other

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
D3 = PUSH
D4 = PUSH
BODY = PUSH ; OLD = PUSH ; SWAY_TO = PUSH ; LOOK = PUSH
FIRST = 0 ; ENOUGH = 0 ; NEXT_ONE = 1
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
  MOVE = D1 - BODY ; MOVE.Z = 0 ; TURN = D1.Z
  IF GROUP == 1 THEN
    MOVE.Z = HEIGHT
  ENDIF
  P3 = ROT_Z H3 TURN ; P3 += MOVE ; PTP F3 P3
  MOVE = D2 - BODY ; MOVE.Z = 0 ; TURN = D2.Z
  IF GROUP == 2 THEN
    MOVE.Z = HEIGHT
  ENDIF
  P1 = ROT_Z H1 TURN ; P1 += MOVE ; PTP F1 P1
  MOVE = D3 - BODY ; MOVE.Z = 0 ; TURN = D3.Z
  IF GROUP == 3 THEN
    MOVE.Z = HEIGHT
  ENDIF
  P4 = ROT_Z H4 TURN ; P4 += MOVE ; PTP F4 P4
  MOVE = D4 - BODY ; MOVE.Z = 0 ; TURN = D4.Z
  IF GROUP == 4 THEN
    MOVE.Z = HEIGHT
  ENDIF
  P2 = ROT_Z H2 TURN ; P2 += MOVE ; PTP F2 P2
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
  CALL WAIT_FOR_FEET:
  GO = LEVEL * TOP
SUBEND

// The body waits when a foot would soon be too far away.
SUBROUTINE WAIT_FOR_FEET:
  WORST = 0
  GO = LEVEL * TOP
  MOVE = GO * SOON
  // In every second cycle it takes a body that has leaned, in the others one that does not lean.
  LOOK = ONE - LOOK
  WAY = SWAY_TO * LOOK
  MOVE += WAY
  MOVE -= BODY
  WAY = P1 - H1 ; WAY -= MOVE ; CALL HOW_FAR:
  WAY = P2 - H2 ; WAY -= MOVE ; CALL HOW_FAR:
  WAY = P3 - H3 ; WAY -= MOVE ; CALL HOW_FAR:
  WAY = P4 - H4 ; WAY -= MOVE ; CALL HOW_FAR:
  IF WORST > REACH THEN
    LEVEL *= BRAKE
  ENDIF
SUBEND

SUBROUTINE HOW_FAR:
  WAY *= WEIGHT
  SIZE = NORM WAY
  IF SIZE > WORST THEN
    WORST = SIZE
  ENDIF
SUBEND

// The feet in the air have landed: it is the turn of the next ones.
SUBROUTINE CHANGE:
  // Back in the reverse order; to the side in either.
  IF LEVEL.Y > CLEAR THEN
    NEXT_ONE = 1
  ELSEIF LEVEL.Y < BACK THEN
    NEXT_ONE = -1
  ENDIF
  GROUP += NEXT_ONE
  IF GROUP > 4 THEN
    GROUP = 1
  ELSEIF GROUP < 1 THEN
    GROUP = 4
  ENDIF
  IF GROUP == 1 THEN
    FROM = D1 ; HOME = H3 ; SWAY_TO = P1 - H1 ; WAY = P4 - H4
  ELSEIF GROUP == 2 THEN
    FROM = D2 ; HOME = H1 ; SWAY_TO = P2 - H2 ; WAY = P3 - H3
  ELSEIF GROUP == 3 THEN
    FROM = D3 ; HOME = H4 ; SWAY_TO = P3 - H3 ; WAY = P2 - H2
  ELSE
    FROM = D4 ; HOME = H2 ; SWAY_TO = P4 - H4 ; WAY = P1 - H1
  ENDIF
  N = 0 ; STANDS = 0 ; HEIGHT = 0
  // The body leans over the feet beside this one, and away from it.
  SWAY_TO += WAY
  SWAY_TO *= HALF
  SWAY_TO += BODY
  WAY = HOME * AWAY
  SWAY_TO -= WAY
  OLD = BODY
  FIRST = LONG
  CALL HOW_LONG:
  CALL HOW_LONG:
  ENOUGH = FIRST + FLIGHT
  PART = STRIDE / 4
  STRIDE -= PART
  STRIDE += ENOUGH
  // At rest, feet that are at home stay there. When all are, the robot stands.
  SIZE = NORM GO
  IF SIZE == 0 THEN
    SIZE = NORM FROM
    IF SIZE == 0 THEN
      N = ENOUGH
      SWAY_TO = BODY
      PART = NORM D1 ; SIZE += PART
      PART = NORM D2 ; SIZE += PART
      PART = NORM D3 ; SIZE += PART
      PART = NORM D4 ; SIZE += PART
      IF SIZE == 0 THEN
        SIZE = NORM BODY
        SWAY_TO = GO ; FIRST = LONG ; ENOUGH = LONG ; N = 0
      ENDIF
      IF SIZE == 0 THEN
        STANDS = 1
        ENOUGH = 0
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
  D3 -= WAY ; D3 = ROT_Z D3 ANGLE
  D4 -= WAY ; D4 = ROT_Z D4 ANGLE
  FROM -= WAY ; FROM = ROT_Z FROM ANGLE
  SWAY_TO -= WAY ; SWAY_TO = ROT_Z SWAY_TO ANGLE
  IF N <= FIRST THEN
    PART = FIRST - N
    CALL AIM:
    PART = N / FIRST
    CALL SMOOTH:
    GOAL *= PLUS
    BODY = OLD + GOAL
  ENDIF
  IF N > FIRST THEN
    IF N <= ENOUGH THEN
      CALL SWING_FEET:
    ENDIF
  ENDIF
SUBEND

// The way of the body from where it leaned, for a swing that begins in PART cycles: the body goes on
// during the swing, and is over its place when half of it is over.
SUBROUTINE AIM:
  SIZE = FLIGHT / 2
  PART += SIZE
  PART *= TICK.X
  PLUS.X = PART ; PLUS.Y = PART ; PLUS.Z = 0
  WAY = GO * PLUS
  GOAL = SWAY_TO - WAY
  GOAL -= OLD
  GOAL.Z = 0
SUBEND

// A shorter way takes less time at the same acceleration: as the root of it.
SUBROUTINE HOW_LONG:
  PART = FIRST
  CALL AIM:
  PART = NORM GOAL
  PART /= FULL
  PART = SQRT PART
  FIRST = PART * LONG
  FIRST = INT FIRST
  IF FIRST < SHORT THEN
    FIRST = SHORT
  ENDIF
SUBEND

// From where they stood to where half of their way on the floor is ahead of them.
SUBROUTINE SWING_FEET:
  PART = STRIDE - FLIGHT
  PART /= 2
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
  ELSEIF GROUP == 2 THEN
    D2 = AIR
  ELSEIF GROUP == 3 THEN
    D3 = AIR
  ELSE
    D4 = AIR
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
