3.1
until without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
UNTIL V == 1
SLEEP 2
END
