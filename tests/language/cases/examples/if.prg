3.1
Which way the knob is turned
DEF_VAR V
AD_IN VR1 V
IF V > 5 THEN
  MESSAGE right
ELSEIF V < -5 THEN
  MESSAGE left
ELSE
  MESSAGE straight on
ENDIF
IF V < 0 GOTO DONE:
MESSAGE not reached
DONE: END
