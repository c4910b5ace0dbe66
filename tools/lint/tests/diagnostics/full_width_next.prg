3.1
A title
DEF_VAR I
FOR I = 1 TO 3
REM
ＮＥＸＴ
END
