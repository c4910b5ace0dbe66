3.2
Read with value on some ways
DEF_VAR A B
IF KB_HIT THEN
A = 1
ENDIF
B = A
SLEEP B
END
