3.1
declared behind end
A = 1
END
DEF_VAR A
