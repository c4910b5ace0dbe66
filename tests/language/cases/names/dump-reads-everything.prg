3.1
dump reads everything
DEF_VAR A B
B = 1
OUTPUT_VARIABLES
END
