3.1
For entered at the limit
DEF_VAR I
FOR I = 5 TO 5
NEXT
FOR I = -1 TO -1 STEP -2
NEXT
END
