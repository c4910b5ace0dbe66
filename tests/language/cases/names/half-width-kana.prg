3.1
A name in half-width kana
DEF_VAR ｱ
DEF_POS P ｲ
P.X = 1
P.Y = P.X
END
