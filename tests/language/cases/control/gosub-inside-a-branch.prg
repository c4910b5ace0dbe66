3.1
Gosub inside a branch
IF 1 == 1 THEN
GOSUB L1:
EXIT
L1: RETURN
ENDIF
END
