3.1
A pause of two cycles
LAMP_ON 1
REM the first cycle
REM the second
LAMP_OFF 1
END
