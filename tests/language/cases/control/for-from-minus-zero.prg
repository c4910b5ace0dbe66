3.1
For from minus zero
DEF_VAR I
FOR I = -0.0 TO 0
NEXT
END
