3.1
A title
DEF_VAR N
N = 0
Ｌ１：
N += 1
IF N < 3 GOTO Ｌ１：
END
