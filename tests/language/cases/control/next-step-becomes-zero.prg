3.1
Next step becomes zero
DEF_VAR I, S
S = 1
FOR I = 1 TO 3 STEP S
S = 0
NEXT
END
