3.1
Elseif without else
DEF_VAR A
IF 1 == 2 THEN
A = 1
ELSEIF 1 == 3 THEN
A = 2
ENDIF
END
