3.1
flag names warn
DEF_VAR R A HS
R = 1
A = R
HS = A
SLEEP HS
END
