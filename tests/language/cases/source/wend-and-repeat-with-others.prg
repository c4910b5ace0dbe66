3.1
wend and repeat with others
WHILE KB_HIT ; WEND
REPEAT ; SLEEP 20
UNTIL KB_HIT ; SLEEP 20
END
