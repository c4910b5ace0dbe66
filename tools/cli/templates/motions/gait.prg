3.2
<<title>>

<<picture>>//
// VR1 forward, VR2 turn to the left, VR3 to the right: 5 V is rest, less is the other way.
// Without sticks the inputs read 0 V. Then keys walk: W S ahead and back, A D turn, Q E sideways,
// and any other key stops. After a halt request the robot sits down.
//
<<figures>>
DEFINE REST 5     // V of a stick that rests
DEFINE RANGE 5    // V from there to either end
DEFINE DEAD 0.08  // part of it that is rest too
DEFINE NONE 0.5   // V that all three have together when there are none
@crawl DEFINE CLEAR 0.4  // part of TOP.Y from which the order of the feet follows the direction
@crawl DEFINE BACK -0.4

@pairs DEF_VAR SWING, STAND, LIFT, DELAY, LEAN, RAISE, LOWER
@wave DEF_VAR SWING, STAND, LIFT, DELAY, REACH, LEAN, RAISE, LOWER
@crawl DEF_VAR SWING, SHIFT, LIFT, DELAY, SWAY, REACH, LEAN, RAISE, LOWER
DEF_VAR PERIOD, FLIGHT, FIRST, ENOUGH, RATE, N, GROUP, STANDS
@steady DEF_VAR STANCE
DEF_VAR VOLTS, STICK, SIZE, PART, ANGLE, TURN, HEIGHT
@single DEF_VAR WORST
@crawl DEF_VAR LONG, SHORT, FULL, STRIDE, NEXT_ONE
DEF_POS <<homes>>  // where the feet stand at rest
DEF_POS <<groups>>  // how far the feet of each group are from there: mm, mm, deg
DEF_POS PUSH, LEVEL, RATES  // the sticks, and how much of them the robot follows: -1 to 1
DEF_POS TOP, GO  // the speed at 1, and that of the body: mm/s, mm/s, deg/s
DEF_POS FROM, AIR  // where the feet in the air come from, and where they are
@steady DEF_POS TICK, PLUS, WAY, MOVE, P
@crawl DEF_POS TICK, PLUS, WAY, MOVE
@crawl DEF_POS <<places>>  // where the feet are
@single DEF_POS SOON, WEIGHT, BRAKE
@crawl DEF_POS BODY, OLD, SWAY_TO  // where the body is to lean, where it leans, and where it leaned
@crawl DEF_POS HOME, AWAY, HALF, GOAL, LOOK, ONE

SWING = <<swing>>  // ms that a foot is in the air
@pairs STAND = <<stand>>  // ms that all feet stand between two swings
@wave STAND = <<stand>>  // ms that all feet stand between two swings
@crawl SHIFT = <<shift>>  // ms for the body to lean to the other side at rest; a shorter way takes less
LIFT = <<lift>>  // mm
DELAY = <<delay>>  // ms from rest to full speed, and back
@crawl SWAY = <<sway>>  // how far the body leans to the middle of the feet that stand: 0 to 1
@single REACH = <<reach>>  // mm that a foot may be ahead of its place, or behind it
@wave WEIGHT.X = <<weight_x>>  // mm ahead that are as far for it as one to the side,
@wave WEIGHT.Z = <<weight_turn>>  // and as a turn of the body by one degree
@crawl WEIGHT.X = <<weight_x>>  // mm ahead that are as far for it as one to the side
LEAN = <<lean>>  // mm that the feet stand behind their initial places: below the mass
RAISE = <<raise>>  // mm that the body is above its initial height
LOWER = <<lower>>  // mm that it sinks to sit
TOP.X = <<side>>  // mm/s
TOP.Y = <<ahead>>  // mm/s
TOP.Z = <<turn>>  // deg/s

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
@steady FIRST = STAND / PERIOD
@steady FIRST = INT FIRST
@steady ENOUGH = FIRST + FLIGHT
@steady STANCE = ENOUGH * <<count>>
@steady STANCE -= FLIGHT  // cycles that a foot stands
@crawl LONG = SHIFT / PERIOD
@crawl LONG = INT LONG
@crawl SHORT = LONG / 4
@crawl SHORT = INT SHORT  // cycles that it takes at least
@crawl STRIDE = LONG + FLIGHT
@crawl STRIDE *= <<count>>  // cycles in which every foot swings once: an estimate
@crawl PART = SWAY / <<others>>
@crawl AWAY.X = PART ; AWAY.Y = PART ; AWAY.Z = 0
@crawl HALF.X = 0.5 ; HALF.Y = 0.5 ; HALF.Z = 0
@single WEIGHT.Y = 1
@crawl WEIGHT.Z = 0
@single SOON.X = 0.3 ; SOON.Y = 0.3 ; SOON.Z = 0.3  // s
@single BRAKE.X = 0.8 ; BRAKE.Y = 0.8 ; BRAKE.Z = 0.8
@crawl ONE.X = 1 ; ONE.Y = 1 ; ONE.Z = 1

INITIAL_POSTURE
WAIT_INPOS ALL
@steady@leg TEACH_POSITION F# H# ; H#.Y -= LEAN ; H#.Z -= RAISE
@crawl@leg TEACH_POSITION F# H# ; H#.Y -= LEAN ; H#.Z -= RAISE ; P# = H#
@leg PTP F# H#
WAIT_INPOS ALL
@crawl WAY = H1 * AWAY
@crawl FULL = NORM WAY
@crawl FULL *= 2  // mm that the body leans from one side to the other

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
@group D# = PUSH
@crawl BODY = PUSH ; OLD = PUSH ; SWAY_TO = PUSH ; LOOK = PUSH
@crawl FIRST = 0 ; ENOUGH = 0 ; NEXT_ONE = 1
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
@leg REL_PTP F# 0 0 LOWER
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
<<move>>SUBEND

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
@single CALL WAIT_FOR_FEET:
GO = LEVEL * TOP
SUBEND

@single // The body waits when a foot would soon be too far away.
@single SUBROUTINE WAIT_FOR_FEET:
@single WORST = 0
@single GO = LEVEL * TOP
@single MOVE = GO * SOON
@wave@group WAY = D# - MOVE ; CALL HOW_FAR:
@crawl // In every second cycle it takes a body that has leaned, in the others one that does not lean.
@crawl LOOK = ONE - LOOK
@crawl WAY = SWAY_TO * LOOK
@crawl MOVE += WAY
@crawl MOVE -= BODY
@crawl@leg WAY = P# - H# ; WAY -= MOVE ; CALL HOW_FAR:
@single IF WORST > REACH THEN
@single LEVEL *= BRAKE
@single ENDIF
@single SUBEND
@single 
@single SUBROUTINE HOW_FAR:
@single WAY *= WEIGHT
@single SIZE = NORM WAY
@single IF SIZE > WORST THEN
@single WORST = SIZE
@single ENDIF
@single SUBEND
@single 
// The feet in the air have landed: it is the turn of the next ones.
SUBROUTINE CHANGE:
@steady GROUP += 1
@crawl // Back in the reverse order; to the side in either.
@crawl IF LEVEL.Y > CLEAR THEN
@crawl NEXT_ONE = 1
@crawl ELSEIF LEVEL.Y < BACK THEN
@crawl NEXT_ONE = -1
@crawl ENDIF
@crawl GROUP += NEXT_ONE
IF GROUP > <<count>> THEN
GROUP = 1
@crawl ELSEIF GROUP < 1 THEN
@crawl GROUP = <<count>>
ENDIF
<<leave>>N = 0 ; STANDS = 0 ; HEIGHT = 0
@crawl // The body leans over the feet beside this one, and away from it.
@crawl SWAY_TO += WAY
@crawl SWAY_TO *= HALF
@crawl SWAY_TO += BODY
@crawl WAY = HOME * AWAY
@crawl SWAY_TO -= WAY
@crawl OLD = BODY
@crawl FIRST = LONG
@crawl CALL HOW_LONG:
@crawl CALL HOW_LONG:
@crawl ENOUGH = FIRST + FLIGHT
@crawl PART = STRIDE / <<count>>
@crawl STRIDE -= PART
@crawl STRIDE += ENOUGH
// At rest, feet that are at home stay there. When all are, the robot stands.
SIZE = NORM GO
IF SIZE == 0 THEN
SIZE = NORM FROM
IF SIZE == 0 THEN
N = ENOUGH
@crawl SWAY_TO = BODY
@group PART = NORM D# ; SIZE += PART
@crawl IF SIZE == 0 THEN
@crawl SIZE = NORM BODY
@crawl SWAY_TO = GO ; FIRST = LONG ; ENOUGH = LONG ; N = 0
@crawl ENDIF
IF SIZE == 0 THEN
STANDS = 1
@crawl ENOUGH = 0
ENDIF
ENDIF
ENDIF
SUBEND

SUBROUTINE ADVANCE:
N += 1
// The floor moves and turns under the body, and with it the feet and the places that they left.
WAY = GO * TICK
ANGLE = -WAY.Z
@group D# -= WAY ; D# = ROT_Z D# ANGLE
FROM -= WAY ; FROM = ROT_Z FROM ANGLE
@crawl SWAY_TO -= WAY ; SWAY_TO = ROT_Z SWAY_TO ANGLE
@crawl IF N <= FIRST THEN
@crawl PART = FIRST - N
@crawl CALL AIM:
@crawl PART = N / FIRST
@crawl CALL SMOOTH:
@crawl GOAL *= PLUS
@crawl BODY = OLD + GOAL
@crawl ENDIF
IF N > FIRST THEN
IF N <= ENOUGH THEN
CALL SWING_FEET:
ENDIF
ENDIF
SUBEND

@crawl // The way of the body from where it leaned, for a swing that begins in PART cycles: the body goes on
@crawl // during the swing, and is over its place when half of it is over.
@crawl SUBROUTINE AIM:
@crawl SIZE = FLIGHT / 2
@crawl PART += SIZE
@crawl PART *= TICK.X
@crawl PLUS.X = PART ; PLUS.Y = PART ; PLUS.Z = 0
@crawl WAY = GO * PLUS
@crawl GOAL = SWAY_TO - WAY
@crawl GOAL -= OLD
@crawl GOAL.Z = 0
@crawl SUBEND
@crawl 
@crawl // A shorter way takes less time at the same acceleration: as the root of it.
@crawl SUBROUTINE HOW_LONG:
@crawl PART = FIRST
@crawl CALL AIM:
@crawl PART = NORM GOAL
@crawl PART /= FULL
@crawl PART = SQRT PART
@crawl FIRST = PART * LONG
@crawl FIRST = INT FIRST
@crawl IF FIRST < SHORT THEN
@crawl FIRST = SHORT
@crawl ENDIF
@crawl SUBEND
@crawl 
// From where they stood to where half of their way on the floor is ahead of them.
SUBROUTINE SWING_FEET:
@steady PART = STANCE / 2
@crawl PART = STRIDE - FLIGHT
@crawl PART /= 2
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
<<swing_feet>>SUBEND

// From 0 to 1, at rest at both ends
SUBROUTINE SMOOTH:
ANGLE = PART * 180
PART = COS ANGLE
PART = 1 - PART
PART /= 2
PLUS.X = PART ; PLUS.Y = PART ; PLUS.Z = PART
SUBEND

END
