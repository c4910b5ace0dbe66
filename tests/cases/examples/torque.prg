3.1
Press a foot onto the floor with a torque
TORQUE J12 -4                // N m: the thigh turns down
SLEEP 200
TORQUE J12 R -4              // 4 more: -8
SLEEP 200
NO_COMPLIANCE J12
END
