3.1
For step zero
DEF_VAR I
REM one
FOR I = 2 TO 1 STEP 0
NEXT
END
