3.2
Read without value on any way
DEF_VAR A B C
A = B
A = B
B = A
C += 1
SLEEP C
END
