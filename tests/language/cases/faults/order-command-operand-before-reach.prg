3.1
Order command operand before reach
DEF_VAR Z
PTP F1 1000 1000 Z
Z = 1
END
