3.1
A title
DEF_VAR T
T = millis();
MESSAGE %T%
END
