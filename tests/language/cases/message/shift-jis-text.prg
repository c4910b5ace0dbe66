3.1
表示
DEF_VAR A
A = 3
MESSAGE 表示ソ能　%A%
END
