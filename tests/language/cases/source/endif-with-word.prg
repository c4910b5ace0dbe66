3.1
endif with word
IF KB_HIT THEN
ENDIF KB_HIT
END
