3.1
For step is its variable
DEF_VAR I
I = 2
FOR I = 2 TO 7 STEP I
NEXT
END
