3.1
Exit finishes
DEF_VAR A
A = 1
EXIT
A = 2
END
