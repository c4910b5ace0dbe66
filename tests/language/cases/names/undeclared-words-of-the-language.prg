3.1
undeclared words of the language
DEF_VAR M
M = ALL
PTP = M
SLEEP KB_HIT
IF F1 == M THEN
ENDIF
END
