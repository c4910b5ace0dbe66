3.1
For without effect on set
DEF_VAR I
I = 3
FOR I = 3 TO 2
NEXT
END
