3.1
A title
DEF_VAR A$
A$ = "hello"
MESSAGE %A%
END
