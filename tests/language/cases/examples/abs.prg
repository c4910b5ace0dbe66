3.1
Is the knob away from its middle?
DEF_VAR V
AD_IN VR1 V
V = ABS V
IF V > 2 THEN
  MESSAGE turned
ENDIF
END
