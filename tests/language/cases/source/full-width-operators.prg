3.1
full width operators
DEF_VAR A
A ＝ 1
A = 20
SLEEP A
END
