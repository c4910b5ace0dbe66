3.1
A menu: a digit, a letter or the space bar
MESSAGE 1, A or space?
KEY_IN
IF VAR_KEY == CHAR_1 THEN
  MESSAGE one
ELSEIF VAR_KEY == CHAR_A THEN
  MESSAGE A
ELSEIF VAR_KEY == CHAR_SPC THEN
  MESSAGE space
ENDIF
END
