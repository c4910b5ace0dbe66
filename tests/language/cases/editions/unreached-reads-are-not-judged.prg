3.2
Unreached reads are not judged
DEF_VAR A B
A = 1
EXIT
A = B
B = A
END
