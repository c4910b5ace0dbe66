3.1
Generic torque limit one negative
REM one
SET_COMPLIANCE_TORQUE_LIMIT F1 1 -1 1
END
