3.1
calls without label
GOSUB
CALL
IF KB_HIT GOSUB
END
