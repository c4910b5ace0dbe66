3.1
crossed blocks
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
IF V == 1 THEN
WHILE V == 1
ENDIF
WEND
END
