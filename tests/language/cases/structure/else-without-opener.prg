3.1
else without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
ELSE
SLEEP 2
END
