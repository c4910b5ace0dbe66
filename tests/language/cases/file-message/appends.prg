3.2
Appends
DEF_VAR A
A = 2.5
F_MESSAGE one
F_MESSAGE   two and three\n
F_MESSAGE
F_MESSAGE a\tb\\n\x\a\
F_MESSAGE A is %A% or %A.1%\n%A.2%
F_MESSAGE lower Case; A = 3
F_MESSAGE \n
END
