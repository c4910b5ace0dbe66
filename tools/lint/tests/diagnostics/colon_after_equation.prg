3.1
A title
DEF_VAR A B
A = 1 : B = 2
MESSAGE %A% %B%
END
