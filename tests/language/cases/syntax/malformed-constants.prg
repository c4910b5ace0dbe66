3.1
malformed constants
DEF_VAR A
A = 20
A = 1.2.3
A = 0x10
A = 5E
A = .
A = 1E309
A = 1E308
SLEEP A
END
