3.1
A title
CONST robtarget p10 := [[391,201,-150],[1,0,0,0]];
ALL_STOP
END
