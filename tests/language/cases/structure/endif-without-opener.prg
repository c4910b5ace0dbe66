3.1
endif without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
ENDIF
SLEEP 2
END
