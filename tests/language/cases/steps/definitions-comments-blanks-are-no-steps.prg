3.1
Definitions comments blanks are no steps

// a comment line
DEF_VAR A
A = 1   // a comment behind

DEF_POS P
   // P.X is never used
A = 2
DEF_JOINT Q
END
