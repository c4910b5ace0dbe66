3.2
Flags in motion arguments
DEFINE R 5
DEF_VAR V
V = R
PTP_ANGLE J11 R 5
END
