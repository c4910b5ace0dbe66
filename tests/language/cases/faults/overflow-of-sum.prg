3.1
Overflow of sum
DEF_VAR A
A = 1.7E308 + 1E308
END
