3.1
For signed operands
DEF_VAR I, N
N = 1
FOR I = -N TO N STEP N
NEXT
FOR I = N TO -N STEP -N
NEXT
END
