3.1
Reads the sticks, and hears no request to halt
DEF_VAR V
DEF_VAR W
DEF_VAR X
LOOP:
AD_IN VR1 V
AD_IN VR2 W
AD_IN VR3 X
GOTO LOOP:
END
