3.1
A title
DEF_VAR I
I = 0
WHILE I < 3 DO
  I += 1
WEND
END
