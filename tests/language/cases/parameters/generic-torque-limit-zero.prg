3.1
Generic torque limit zero
REM one
SET_COMPLIANCE_TORQUE_LIMIT J11 0
END
