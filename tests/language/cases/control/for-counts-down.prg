3.1
For counts down
DEF_VAR I
FOR I = 1 TO 0 STEP -0.5
NEXT
END
