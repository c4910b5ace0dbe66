3.1
Ends at semicolon and comment
DEF_VAR A
MESSAGE one ; A = 1
MESSAGE two // not shown
REM note ; A = 2
END
