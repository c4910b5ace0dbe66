3.1
Zero by zero
DEF_VAR A
A = 0 / 0
END
