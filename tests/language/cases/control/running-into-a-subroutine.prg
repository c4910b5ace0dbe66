3.1
Running into a subroutine
DEF_VAR A
A = 1
SUBROUTINE S1:
A = 2
SUBEND
END
