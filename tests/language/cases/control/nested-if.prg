3.1
Nested if
DEF_VAR A
IF 1 == 1 THEN
  IF 1 == 2 THEN
    A = 1
  ELSEIF 2 == 2 THEN
    A = 2
  ENDIF
ELSE
  A = 3
ENDIF
END
