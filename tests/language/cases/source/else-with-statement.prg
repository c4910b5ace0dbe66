3.1
else with statement
IF KB_HIT THEN
ELSE X = 1
ENDIF
END
