3.1
shown by output variables
DEF_VAR M, B
M = 1
OUTPUT_VARIABLES
END
