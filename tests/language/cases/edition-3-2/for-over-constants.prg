3.2
A FOR that never runs assigns nothing
DEFINE LAST 0
DEF_VAR I A
FOR I = 1 TO LAST
  A = 1
NEXT
SLEEP A
END
