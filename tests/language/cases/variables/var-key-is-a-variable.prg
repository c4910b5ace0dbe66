3.1
Var key is a variable
DEF_VAR A
VAR_KEY = CHAR_B
A = VAR_KEY + 1
VAR_KEY *= 2
END
