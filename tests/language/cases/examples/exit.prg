3.1
Leave early if nobody turned the knob
DEF_VAR V
AD_IN VR1 V
IF V < 1 THEN
  MESSAGE nobody did
  EXIT
ENDIF
REL_PTP F1 0 0 30
WAIT_INPOS F1
MESSAGE lifted
END
