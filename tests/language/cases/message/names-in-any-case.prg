3.1
Names in any case
DEF_VAR Speed
SPEED = 3
MESSAGE %speed% %SpEeD.1% speed
END
