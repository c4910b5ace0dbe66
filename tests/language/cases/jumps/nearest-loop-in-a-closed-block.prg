3.1
nearest loop in a closed block
LOOP:
WHILE KB_HIT
LOOP:
WEND
GOTO
IF KB_HIT GOTO LOOP:
END
