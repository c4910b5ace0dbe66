3.1
subroutine never closed
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
EXIT
SUBROUTINE S1:
SLEEP 1
END
