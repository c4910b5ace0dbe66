3.1
For not entered
DEF_VAR I, J
FOR I = 2 TO 1
J = 1
NEXT
FOR I = 1 TO 2 STEP -1
J = 1
NEXT
END
