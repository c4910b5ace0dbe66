3.1
A count whose end is glued to its beginning
DEF_VAR N
FOR N = 1TO 3
  MESSAGE %N%
NEXT N
END
