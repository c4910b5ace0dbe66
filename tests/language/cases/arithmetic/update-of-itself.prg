3.1
Update of itself
DEF_VAR A
A = 3
A += A
A *= A
A -= -A
A /= A
END
