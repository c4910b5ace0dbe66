3.1
Lamp below the range
DEF_VAR D
D = -1
LAMP_ON D
END
