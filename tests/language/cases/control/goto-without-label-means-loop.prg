3.1
Goto without label means loop
DEF_VAR N
LOOP:
N = 0
LOOP:
N += 1
IF N < 2 GOTO
IF N == 3 GOTO OUT:
GOTO
OUT: END
