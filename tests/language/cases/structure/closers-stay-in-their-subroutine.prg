3.1
closers stay in their subroutine
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
EXIT
SUBROUTINE S1:
WEND
SUBEND
SUBROUTINE S2:
IF V == 1 THEN
SUBEND
END
