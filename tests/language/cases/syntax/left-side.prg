3.1
left side
DEF_VAR A
A = 20
-A = 5
5 = A
= 5
A = 5
SLEEP A
END
