3.1
A careful knee: half the speed, a tenth of the acceleration
SET_OMEGA_MAX_RATE J13 50
SET_OMEGA_DOT_MAX_RATE J13 10
PTP_ANGLE J13 60
WAIT_INPOS J13
END
