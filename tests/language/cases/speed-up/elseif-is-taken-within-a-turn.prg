3.2
Elseif is taken within a turn
DEF_VAR A
A = 1
TIP_SPEED_UP 20
IF A == 1 THEN
A = 2
ELSEIF A == 2 THEN
A = 3
ELSE
A = 4
ENDIF
IF A == 1 THEN
A = 5
ELSEIF A == 2 THEN
A = 6
ELSE
A = 7
ENDIF
END
