3.1
endif before label
IF KB_HIT THEN
ENDIF ; L1:
GOTO L1:
END
