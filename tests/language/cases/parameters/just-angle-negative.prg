3.1
Just angle negative
REM one
SET_JUST_ANGLE J11 -1
END
