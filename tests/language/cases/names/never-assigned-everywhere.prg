3.1
never assigned everywhere
DEF_VAR M, B, C, D, E, I
MESSAGE a %M%
IF B > 1 THEN
ENDIF
FOR I = 1 TO C STEP D
NEXT
SPECIAL 1 E
KEY_IN
END
