3.1
Message unassigned
DEF_VAR A
MESSAGE one
MESSAGE value %A%
A = 1
END
