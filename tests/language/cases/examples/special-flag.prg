3.1
Carry up by 5 mm what the fingers hold, and go on when that is done
SPECIAL 5 20 5               // 20 mN m/deg, 5 mm
REPEAT
  SPECIAL 6 0 20             // 20 mm/s upwards
UNTIL SPECIAL_FLAG0
MESSAGE lifted
END
