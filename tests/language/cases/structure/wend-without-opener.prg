3.1
wend without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
WEND
SLEEP 2
END
