3.1
Speed rate zero
REM one
SET_V_MAX_RATE F1 0
END
