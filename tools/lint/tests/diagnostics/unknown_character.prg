3.1
A title
DEF_VAR N
N = 5 ÷ 2
END
