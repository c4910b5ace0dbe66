3.1
Sum of squares
DEF_VAR I, S, SUM
SUM = 0
FOR I = 1 TO 3
  S = I * I
  SUM += S
NEXT I
MESSAGE sum %SUM%
END
