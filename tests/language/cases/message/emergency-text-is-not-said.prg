3.1
Emergency text is not said
DEF_VAR A, B
A = 1
MESSAGE %A% and %B%
B = 1
END
