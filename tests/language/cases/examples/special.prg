3.1
The fingertip of F1 rolls what it holds, for 0.3 s
DEF_VAR ANGLE
SPECIAL 14 40                // 40 Hz
SPECIAL 11 4 2               // clockwise, 2 V
SLEEP 305
TEACH_ANGLE J13 ANGLE
MESSAGE J13 swings to %ANGLE.2% deg
SPECIAL 10                   // off
END
