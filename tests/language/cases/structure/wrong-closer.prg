3.1
wrong closer
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
REPEAT
WEND
SLEEP 1
END
