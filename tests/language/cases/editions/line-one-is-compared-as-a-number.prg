3.20 // the edition
Line one is compared as a number
DEF_VAR A
DEFINE FIVE 5
A = FIVE
END
