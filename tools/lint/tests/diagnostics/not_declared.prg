3.1
A title
FOR I = 1 TO 3
N = I + 1
NEXT I
END
