3.1
endif behind statement
IF KB_HIT THEN
SLEEP 20 ; ENDIF
END
