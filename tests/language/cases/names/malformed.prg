3.1
malformed
DEF_VAR 5A 1 P.X A$B _5, A5
DEF_POS .X
_5 = 1
A5 = _5
SLEEP A5
END
