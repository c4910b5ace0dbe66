3.1
if without then
IF KB_HIT
ENDIF
IF 1 == 1
ENDIF
END
