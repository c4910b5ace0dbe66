3.1
Lever motion, then a lamp
SPECIAL 1
LAMP_ON 0
END
