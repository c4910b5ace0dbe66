3.1
Speed rate above hundred
REM one
SET_V_MAX_RATE ALL 100.1
END
