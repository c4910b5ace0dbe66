3.1
Blank before the colon of a label
DEF_VAR A
GOTO SKIP:
A = 1
SKIP :
A = 2
END
