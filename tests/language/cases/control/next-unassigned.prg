3.1
Next unassigned
DEF_VAR I
GOTO L1:
FOR I = 1 TO 3
L1:
NEXT
END
