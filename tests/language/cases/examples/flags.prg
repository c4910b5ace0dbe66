3.1
A motion with one coordinate as it is, one absolute and one relative
DEF_VAR Y, Z
DEF_POS P
PTP HS F1 R 0 A 251 R 20     // HS: without limit of acceleration
WAIT_INPOS F1
TEACH_POSITION F1 P
Y = P.Y
Z = P.Z
MESSAGE its y is %Y%, its z %Z%
END
