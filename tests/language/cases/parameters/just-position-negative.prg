3.1
Just position negative
REM one
SET_JUST_POSITION F1 -0.1
END
