3.1
Stands up when a voltage says so
DEF_VAR V
WAIT:
  AD_IN VR1 V
  IF V < 5 GOTO WAIT:
MESSAGE %V.1% V: standing up
STAND_UP 60
WAIT_INPOS ALL
END
