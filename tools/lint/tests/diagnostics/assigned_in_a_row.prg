3.1
A title
DEF_VAR A B
A = B = 1
MESSAGE %A% %B%
END
