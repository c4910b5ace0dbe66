3.1
Points on a circle of 100 mm
DEF_VAR ANGLE, X, Y, T
FOR ANGLE = 0 TO 60 STEP 60
  X = COS ANGLE
  X *= 100
  Y = SIN ANGLE
  Y *= 100
  MESSAGE %X.1% %Y.1%
NEXT
T = TAN 45
MESSAGE the slope at 45 deg is %T.1%
END
