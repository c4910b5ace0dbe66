3.1
If in a loop anew
DEF_VAR N
N = 0
WHILE N < 2
IF N == 0 THEN
N = 1
ELSEIF N == 1 THEN
N = 2
ENDIF
WEND
END
