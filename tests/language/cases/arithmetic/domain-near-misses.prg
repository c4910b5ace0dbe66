3.1
Domain near misses
DEF_VAR A
A = SQRT 0
A = ASIN 1
A = ASIN -1
A = ACOS 1
A = ACOS -1
A = ATAN 1
A = ATAN -1
A = ATAN2 0 1E-300
A = 0 / 1E-300
A = TAN 90
A = 1E-300 * 1E-300
END
