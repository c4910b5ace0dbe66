3.1
Order next variable before step
DEF_VAR I
GOTO L1:
FOR I = 1 TO 2 STEP 0
L1: NEXT
END
