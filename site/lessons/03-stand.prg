3.1
Stands up as high as a variable says
DEF_VAR HEIGHT
HEIGHT = 2 * 30      // mm
STAND_UP HEIGHT
WAIT_INPOS ALL
MESSAGE %HEIGHT.0% mm above the floor
END
