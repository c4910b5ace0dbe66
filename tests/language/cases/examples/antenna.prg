3.1
Go forward until the feeler touches something
DEF_VAR V
REPEAT
  REL_PTP F1 0 10 0
  WAIT_INPOS F1
  AD_IN ANTENNA V
UNTIL V > 1
MESSAGE something is there
END
