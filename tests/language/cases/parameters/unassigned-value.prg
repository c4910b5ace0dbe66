3.1
Unassigned value
DEF_VAR V
SET_V_MAX F1 V
V = 1
END
