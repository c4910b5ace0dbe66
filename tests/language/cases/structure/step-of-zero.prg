3.1
step of zero
DEF_VAR I, J, V
V = 1
I = V
J = I
V = J
FOR I = 1 TO 2 STEP 0
NEXT
FOR I = 1 TO 2 STEP -0.1
NEXT
END
