3.1
Return once too often
GOSUB L1:
L1: RETURN
END
