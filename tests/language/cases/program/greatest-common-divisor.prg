3.1
Greatest common divisor
DEF_VAR X, Y
X = 12
Y = 8
WHILE X <> Y
  IF X > Y THEN
    X -= Y
  ELSE
    Y -= X
  ENDIF
WEND
MESSAGE %X%
END
