3.2
@ words wherever a variable is read
DEF_VAR A
DEF_POS P
A = -@AGL_J13
A = @POS_F1.X + @POS_F1.Y
P = @POS_F1 - @POS_F1
A = NORM @AGL_F1
IF @AGL_J13 > 89 THEN
PTP_ANGLE J11 @TIMER0
ENDIF
END
