3.1
next without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
NEXT
SLEEP 2
END
