3.1
For limit is its variable
DEF_VAR I
I = 5
FOR I = 7 TO I
NEXT
I = 1
FOR I = 1 TO I
NEXT
END
