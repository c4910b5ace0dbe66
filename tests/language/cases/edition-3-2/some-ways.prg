3.2
A read that finds a value on some ways
DEF_VAR A
IF KB_HIT THEN
  A = 1
ENDIF
SLEEP A
END
