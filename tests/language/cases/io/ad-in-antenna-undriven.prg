3.1
Ad in antenna undriven
DEF_VAR V
AD_IN ANTENNA V
AD_IN VR3 V
END
