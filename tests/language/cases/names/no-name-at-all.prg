3.1
no name at all
DEF_VAR
DEF_POS
DEF_JOINT // nothing
DEF_VAR A
A = 1
SLEEP A
END
