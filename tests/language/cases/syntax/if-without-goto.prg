3.1
if without goto
L1:
IF KB_HIT L1:
END
