3.1
Torque and a spring against the weight of a shank
// Five legs carry the robot, the thigh of the first is raised by 55 deg: its free shank hangs at J13 = 145 deg. The shank
// has 0.1 kg, its middle 50 mm from the knee: its weight turns it with 0.1 * 9.80665 * 0.05 = 0.0490333 N*m times the sine.
DEF_VAR A, GAP
PTP_ANGLE J12 55
WAIT_INPOS J12
TORQUE J13 0
SLEEP 5000
TEACH_ANGLE J13 A
GAP = A - 145
GAP = ABS GAP
IF GAP < 0.2 THEN
  MESSAGE it hangs
ENDIF
// Half of the greatest torque holds it 30 deg further out.
TORQUE J13 -0.0245166
SLEEP 5000
TEACH_ANGLE J13 A
GAP = A - 115
GAP = ABS GAP
IF GAP < 0.2 THEN
  MESSAGE it is held out
ENDIF
TEACH_TORQUE J13 A
GAP = A + 0.0245166
GAP = ABS GAP
IF GAP < 0.000001 THEN
  MESSAGE its torque is sensed
ENDIF
// A spring towards 115 deg gives way until both torques are equal.
SET_ANGLE_STIFFNESS J13 0.0025
COMPLIANCE_ANGLE J13 115
SLEEP 10000
TEACH_ANGLE J13 A
GAP = 145 - A
GAP = SIN GAP
GAP *= 0.0490333
A = 115 - A
A *= 0.0025
GAP += A
GAP = ABS GAP
A /= -0.0025
IF GAP < 0.0003 THEN
  MESSAGE the spring carries it
ENDIF
IF A > 5 THEN
  MESSAGE and gives way
ENDIF
END
