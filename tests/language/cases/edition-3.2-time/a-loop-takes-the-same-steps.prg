3.2
A loop at four steps a turn
DEF_VAR A I
A = 0
TIP_SPEED_UP 4
FOR I = 1 TO 2
A += I
NEXT
END
