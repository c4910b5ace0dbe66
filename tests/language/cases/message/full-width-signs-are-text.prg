3.1
Full width signs are text
DEF_VAR A
A = 1
MESSAGE ％A％＼a %A%
END
