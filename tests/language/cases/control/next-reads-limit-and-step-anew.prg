3.1
Next reads limit and step anew
DEF_VAR I
DEF_POS P
P.X = 10
P.Y = 1
FOR I = 1 TO P.X STEP P.Y
P.X = 4
P.Y = 2
NEXT
END
