3.1
Keys and esc in one cycle
KEY_IN
IF HALT_REQUEST GOTO L1:
EXIT
L1: END
