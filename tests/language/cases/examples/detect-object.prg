3.1
Take hold of what stands between the fingers
DEF_VAR ANGLE
DETECT_OBJECT 1
TORQUE J11 20                // and press from the left
TEACH_ANGLE J21 ANGLE
MESSAGE J21 has closed to %ANGLE% deg
END
