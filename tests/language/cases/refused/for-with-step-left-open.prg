3.1
A FOR with STEP that nothing closes
DEF_VAR I
FOR I = 1 TO 2 STEP 1
SLEEP I
END
