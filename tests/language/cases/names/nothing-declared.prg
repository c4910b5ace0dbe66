3.1
nothing declared
DEF_VAR
DEF_POS ; DEF_JOINT , ,
DEF_VAR M
M = 1
SLEEP M
END
