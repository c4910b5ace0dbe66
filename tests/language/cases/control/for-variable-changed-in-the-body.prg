3.1
For variable changed in the body
DEF_VAR I
FOR I = 1 TO 3
I = I * 2
NEXT
END
