3.1
Back from ratios to angles
DEF_VAR U, V, W
U = ASIN 0.5
V = ACOS 0.5
W = ATAN 1
MESSAGE %U.1% %V.1% %W.1%
END
