3.1
For quarter steps
DEF_VAR I
FOR I = 0 TO 0.5 STEP 0.25
NEXT
END
