3.1
Lamp above the range
DEF_VAR D
D = 256
LAMP_ON D
END
