3.1
Grasp, lift, hold and put back, again and again
DEF_POS TIP
DEF_VAR FLOORY, GRIP, AX, AY, BX, BY, CX, CY

AGAIN:
// 1. The floor goes down, so that there is room. First joints close until fingertips feel it.
PTP FLOOR 0 -155 0
PTP_ANGLE F1 -50 0 20
PTP_ANGLE F2 -50 0 20
PTP_ANGLE F3 -50 0 20
WAIT_INPOS ALL
DETECT_FLOOR ALL 1
TEACH_POSITION F1 TIP
FLOORY = TIP.Y
MESSAGE The floor is at %FLOORY.1% mm.

// 2. Up, and to the cylinder, above its middle: so it hangs and does not topple.
GRIP = FLOORY + 40
PTP F1 -85 GRIP 0
PTP F2 85 GRIP 0
PTP F3 85 GRIP 0
WAIT_INPOS ALL
PTP F1 -56 GRIP 0
PTP F2 56 GRIP 0
PTP F3 56 GRIP 0
WAIT_INPOS ALL

// 3. First joints grasp by torque. F1 is opposed by two: it pushes twice as hard.
TORQUE J11 200
TORQUE J21 100
TORQUE J31 100
SLEEP 700
MESSAGE Grasped.
GOSUB TELL:

// 4. Springs take over: their set points go 8 mm inwards, then up.
SET_POSITION_STIFFNESS F1 0.4 0.4 0.4
SET_POSITION_STIFFNESS F2 0.2 0.2 0.2
SET_POSITION_STIFFNESS F3 0.2 0.2 0.2
REL_COMPLIANCE_POSITION F1 8 0 0
REL_COMPLIANCE_POSITION F2 -8 0 0
REL_COMPLIANCE_POSITION F3 -8 0 0
SLEEP 700
SET_V_MAX_SLOW ALL
REL_COMPLIANCE_POSITION F1 0 42 0
REL_COMPLIANCE_POSITION F2 0 42 0
REL_COMPLIANCE_POSITION F3 0 42 0
SLEEP 1800
MESSAGE Lifted.
GOSUB TELL:

// 5. Active friction control: the fingertip of F1 vibrates at 30 Hz, by 1 V.
SPECIAL 14 30
SPECIAL 11 1 1
SLEEP 3000
MESSAGE Held while a fingertip vibrated.
GOSUB TELL:
SPECIAL 10

// 6. Back to the floor, and let go.
REL_COMPLIANCE_POSITION F1 0 -42 0
REL_COMPLIANCE_POSITION F2 0 -42 0
REL_COMPLIANCE_POSITION F3 0 -42 0
SLEEP 1800
PTP F1 -85 GRIP 0
PTP F2 85 GRIP 0
PTP F3 85 GRIP 0
WAIT_INPOS ALL
MESSAGE Put back.
GOTO AGAIN:

// The forces with which the fingertips push, as the torque sensors tell them.
TELL:
TEACH_FORCE F1 TIP
AX = TIP.X
AY = TIP.Y
TEACH_FORCE F2 TIP
BX = TIP.X
BY = TIP.Y
TEACH_FORCE F3 TIP
CX = TIP.X
CY = TIP.Y
MESSAGE It feels (%AX.2%, %AY.2%) (%BX.2%, %BY.2%) (%CX.2%, %CY.2%) N.
RETURN
END
