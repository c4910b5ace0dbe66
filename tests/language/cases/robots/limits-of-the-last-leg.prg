3.2
The limits of the last joint of the last leg
SET_LIMIT J99 -45 45
SET_LIMIT J99 -45 45.5
SET_LIMIT J11 -46 45
END
