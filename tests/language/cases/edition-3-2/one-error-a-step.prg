3.2
Two constants out of range
SET_JUST_ANGLE F1 1 -2 -3
SET_LIMIT J11 -70 70
END
