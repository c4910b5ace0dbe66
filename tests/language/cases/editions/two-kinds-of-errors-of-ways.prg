3.2
Two kinds of errors of ways
DEF_VAR A B
SLEEP -1
A = B
B = A
SUBROUTINE S:
SUBEND
END
