3.1
Counts to three and tells about it
DEF_VAR N, SUM
SUM = 0
FOR N = 1 TO 3
  SUM += N          // a comment is no step
  MESSAGE {%N%} makes %SUM.1%
NEXT N
IF SUM == 6 GOTO DONE:
SUM = -SUM
DONE: END
