3.1
Order for operands before step
DEF_VAR I, E
FOR I = 1 TO E STEP 0
NEXT
E = 1
END
