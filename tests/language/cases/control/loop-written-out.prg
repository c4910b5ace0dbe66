3.1
Loop written out
DEF_VAR N
N = 0
LOOP:
LOOP: N += 1
IF N < 2 GOTO LOOP:
IF N == 2 GOTO
END
