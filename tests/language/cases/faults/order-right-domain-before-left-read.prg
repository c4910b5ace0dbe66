3.1
Order right domain before left read
DEF_VAR A
A += 1 / 0
A = 1
END
