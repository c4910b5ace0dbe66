3.1
A title
DEF_VAR I
FOR (I = 0; I < 3; I++)
  MESSAGE %I%
NEXT
END
