3.1
Output with unassigned variables
DEF_VAR A
OUTPUT_VARIABLES
A = 1
END
