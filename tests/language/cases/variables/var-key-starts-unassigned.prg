3.1
Var key starts unassigned
DEF_VAR A
A = VAR_KEY
KEY_IN
END
