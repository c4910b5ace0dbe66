3.1
Lamp unassigned
DEF_VAR D
LAMP_ON D
D = 1
END
