3.1
Constants for which an equation has no result
DEF_VAR V
V = 1
V = V / 0
V = SQRT -4
V = ASIN 1.5
V = ACOS -2
V = ATAN 3
V = ATAN2 0 0
V += V / 0
V += SQRT -4
V += ASIN 1.5
V += ACOS -2
V += ATAN 3
V += ATAN2 0 0
V -= V / 0
V -= SQRT -4
V -= ASIN 1.5
V -= ACOS -2
V -= ATAN 3
V -= ATAN2 0 0
V *= V / 0
V *= SQRT -4
V *= ASIN 1.5
V *= ACOS -2
V *= ATAN 3
V *= ATAN2 0 0
V /= V / 0
V /= SQRT -4
V /= ASIN 1.5
V /= ACOS -2
V /= ATAN 3
V /= ATAN2 0 0
V /= 0
V = 1 / -0
END
