3.1
The third side of a triangle
DEF_VAR B, C, D
B = 3 * 3
C = 4 * 4
D = B + C
D = SQRT D
MESSAGE %D%
END
