3.1
A knob by its name and by its channel, and the pressure under a foot
DEF_VAR KNOB, SAME, SOLE
AD_IN VR1 KNOB
AD_IN 0 13 SAME
AD_IN PAW1 SOLE
MESSAGE %KNOB.1% V, %SAME.1% V, %SOLE.1% V
END
