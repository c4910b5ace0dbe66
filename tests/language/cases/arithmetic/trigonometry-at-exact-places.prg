3.1
Trigonometry at exact places
DEF_VAR A
A = 5
A = SIN 0
A = COS 0
A = TAN 0
A = 5
A = ASIN 0
A = 5
A = ACOS 1
A = 5
A = ATAN 0
A = 5
A = DEG2RAD 0
A = 5
A = RAD2DEG 0
END
