3.1
Lamp off not fitted
LAMP_OFF 255
END
