3.1
Lift a foot bit by bit until the knob says enough
DEF_VAR V
REPEAT
  REL_PTP F1 0 0 10
  WAIT_INPOS F1
  AD_IN VR1 V
UNTIL V > 5
MESSAGE enough: the knob says %V% V
END
