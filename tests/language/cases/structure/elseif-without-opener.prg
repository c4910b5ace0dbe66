3.1
elseif without opener
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
SLEEP 1
ELSEIF V == 1 THEN
SLEEP 2
END
