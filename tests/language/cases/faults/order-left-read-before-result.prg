3.1
Order left read before result
DEF_VAR A
A /= 0
A = 1
END
