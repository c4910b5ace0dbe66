3.1
Generic force limit zero
REM one
SET_COMPLIANCE_FORCE_LIMIT F1 1 0 1
END
