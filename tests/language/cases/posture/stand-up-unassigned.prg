3.1
Stand up unassigned
DEF_VAR H
STAND_UP H
H = 1
END
