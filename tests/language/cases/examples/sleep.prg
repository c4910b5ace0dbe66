3.1
A lamp shines for a tenth of a second
LAMP_ON 1
SLEEP 100
LAMP_OFF 1
END
