3.1
Lamp not fitted
LAMP_ON 7
LAMP_ON 8
END
