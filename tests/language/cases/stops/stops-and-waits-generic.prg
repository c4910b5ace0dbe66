3.1
Stops and waits of generic: what stops a program
DEF_VAR LINE LATE LOW
AD_IN VR1 LINE
LOW = -1
IF LINE <> 6 GOTO L6:; SLEEP LATE; L6:
IF LINE <> 7 GOTO L7:; SLEEP LOW; L7:
IF LINE <> 8 GOTO L8:; WAIT_NEAR F1; L8:
LATE = 1
END
