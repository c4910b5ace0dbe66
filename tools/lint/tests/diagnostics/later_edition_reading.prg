3.1
A title
DEF_VAR D
D = -@timer1
MESSAGE %D%
END
