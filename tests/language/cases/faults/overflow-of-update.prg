3.1
Overflow of update
DEF_VAR A
A = 2
A *= 1.5E308
END
