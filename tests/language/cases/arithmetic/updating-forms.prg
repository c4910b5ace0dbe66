3.1
Updating forms
DEF_VAR A
A = 10
A += 2
A -= 4
A *= 3
A /= 16
A = 10
A -= 2 - 3
A *= 1 + 1
A /= 2 * 2
A += ABS -3
END
