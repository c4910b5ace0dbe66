3.1
A title
DEF_VAR N
AD_IN VR1 N
MESSAGE the knob reads $N
END
