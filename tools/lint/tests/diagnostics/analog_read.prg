3.1
A title
DEF_VAR V
V = analogRead(0)
SLEEP V
END
