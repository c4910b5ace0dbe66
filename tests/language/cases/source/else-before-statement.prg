3.1
else before statement
IF KB_HIT THEN
ELSE ; SLEEP 20
ENDIF
END
