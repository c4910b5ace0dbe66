3.1
Near angle negative
REM one
SET_NEAR_ANGLE ALL -1
END
