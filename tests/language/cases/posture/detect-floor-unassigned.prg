3.1
Detect floor unassigned
DEF_VAR T
DETECT_FLOOR ALL T
T = 1
END
