3.1
A title
DEF_VAR I
I = 0
DO
  I += 1
LOOP WHILE I < 3
END
