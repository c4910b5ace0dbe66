3.1
Generic force modes have no target
PTP F1 -391 201 -200
TORQUE J11 0
WAIT_NEAR J12
WAIT_NEAR J11
END
