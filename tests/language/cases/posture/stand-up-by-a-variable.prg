3.1
Stand up by a variable
DEF_VAR H
H = -50.5
STAND_UP -H
END
