3.1
subend without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
SUBEND
SLEEP 2
END
