3.1
Struct placeholders of the first
DEF_VAR A
DEF_POS P
A = 1
P.X = A
A = P.X
MESSAGE %P% %P.X% %P.X.1% %A.1%
END
