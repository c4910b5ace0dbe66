3.1
Sleep of a variable
DEF_VAR T
T = -40
SLEEP -T
T = -0.0
SLEEP T
END
