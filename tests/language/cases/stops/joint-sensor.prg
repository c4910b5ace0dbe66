3.1
An input that is a joint
DEF_VAR V
AD_IN J11 V
SLEEP V
END
