3.1
For counts up
DEF_VAR I
FOR I = 1 TO 3
REM body
NEXT I
END
