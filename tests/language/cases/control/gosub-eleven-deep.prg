3.1
Gosub eleven deep
L1:
GOSUB L1:
END
