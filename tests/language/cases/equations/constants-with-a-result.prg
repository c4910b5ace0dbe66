3.1
Constants that are just good enough for an equation
DEF_VAR V
V = 1
V = 0 / V
V = V / 0.001
V /= -1
V *= 0
V = V * 0
V = SQRT 0
V = ASIN 1
V = ACOS -1
V = ATAN 1
V = ATAN2 0 1
V = ATAN2 -1 0
V = ATAN2 V 0
V = SIN 3
V = V - 0
END
