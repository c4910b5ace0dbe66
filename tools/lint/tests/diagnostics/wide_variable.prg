3.1
A title
DEF_VAR Ｎ
Ｎ = 3
SLEEP Ｎ
END
