3.1
Just angle one of three negative
REM one
SET_JUST_ANGLE F1 1 1 -1
END
