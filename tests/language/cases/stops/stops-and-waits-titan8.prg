3.1
Stops and waits of titan8: what stops a program
DEF_VAR LINE LATE
AD_IN VR1 LINE
IF LINE <> 5 GOTO L5:; SLEEP LATE; L5:
LATE = 1
END
