3.1
What it is assigned to is a number
DEF_VAR SPEED
SPEED = FAST
SET_V_MAX ALL SPEED
END
