3.1
Unassigned right operand
DEF_VAR A, B
A = 1
WHILE A < B
WEND
B = 1
END
