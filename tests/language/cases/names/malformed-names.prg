3.1
malformed names
DEF_VAR 1A A.B C#
DEF_VAR _1 A1
_1 = 1
A1 = _1
SLEEP A1
END
