3.1
refused declaration is told once
DEF_VAR F1 1A
DEF_VAR B
B = 1
SLEEP B
END
