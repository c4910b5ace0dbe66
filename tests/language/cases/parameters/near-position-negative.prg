3.1
Near position negative
REM one
SET_NEAR_POSITION ALL -10
END
