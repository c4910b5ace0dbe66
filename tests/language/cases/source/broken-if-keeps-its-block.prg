3.1
broken if keeps its block
IF 左 == 1 THEN
SLEEP 20
ELSE
SLEEP 40
ENDIF
END
